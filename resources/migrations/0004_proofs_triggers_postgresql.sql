-- The secret stays.
CREATE TRIGGER store_secret_stays BEFORE DELETE ON store_secret
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('The secret of the store stays as it is.');
CREATE TRIGGER store_secret_stays_all BEFORE TRUNCATE ON store_secret
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('The secret of the store stays as it is.');
CREATE TRIGGER store_secret_fixed BEFORE UPDATE ON store_secret
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('The secret of the store stays as it is.');

-- What vouches for an attempt stays; one that nothing vouches for can be accepted, once.
CREATE TRIGGER proofs_stay BEFORE DELETE ON proofs
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('The proof of an attempt stays as it is.');
CREATE TRIGGER proofs_stay_all BEFORE TRUNCATE ON proofs
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('The proof of an attempt stays as it is.');
CREATE TRIGGER proofs_fixed BEFORE UPDATE ON proofs FOR EACH ROW
WHEN (NOT (OLD.state = 'unproven' AND NEW.state = 'accepted' AND NEW.attempt = OLD.attempt))
  EXECUTE FUNCTION insonate_refuse('The proof of an attempt stays as it is.');
