-- As before; on a workstation of a site, which always has a file, a server that could not verify an attempt withdraws the
-- workstation's proof.
DROP TRIGGER proofs_fixed;
CREATE TRIGGER proofs_fixed BEFORE UPDATE ON proofs
WHEN NOT (NEW.attempt = OLD.attempt AND ((OLD.state = 'unproven' AND NEW.state = 'accepted')
  OR (OLD.state = 'proven' AND NEW.state = 'unproven' AND EXISTS (SELECT 1 FROM site WHERE server LIKE 'http%'))))
BEGIN
  SELECT RAISE(ABORT, 'The proof of an attempt stays as it is.');
END;
