-- The secret stays.
CREATE TRIGGER store_secret_stays BEFORE DELETE ON store_secret
BEGIN
  SELECT RAISE(ABORT, 'The secret of the store stays as it is.');
END;

-- REPLACE deletes without a word where recursive triggers are off.
CREATE TRIGGER store_secret_comes_once BEFORE INSERT ON store_secret
WHEN EXISTS (SELECT 1 FROM store_secret)
BEGIN
  SELECT RAISE(ABORT, 'The secret of the store stays as it is.');
END;

CREATE TRIGGER store_secret_fixed BEFORE UPDATE ON store_secret
BEGIN
  SELECT RAISE(ABORT, 'The secret of the store stays as it is.');
END;

-- What vouches for an attempt stays; one that nothing vouches for can be accepted, once.
CREATE TRIGGER proofs_stay BEFORE DELETE ON proofs
BEGIN
  SELECT RAISE(ABORT, 'The proof of an attempt stays as it is.');
END;

CREATE TRIGGER proofs_come_once BEFORE INSERT ON proofs
WHEN EXISTS (SELECT 1 FROM proofs WHERE attempt = NEW.attempt)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: proofs.');
END;

CREATE TRIGGER proofs_fixed BEFORE UPDATE ON proofs
WHEN NOT (OLD.state = 'unproven' AND NEW.state = 'accepted' AND NEW.attempt = OLD.attempt)
BEGIN
  SELECT RAISE(ABORT, 'The proof of an attempt stays as it is.');
END;
