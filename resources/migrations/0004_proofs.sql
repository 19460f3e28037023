-- From this the nonces and keys of recordings are derived (AttemptSeal.h): 32 random bytes, hexadecimal, which the program
-- makes as it first opens the store.
CREATE TABLE store_secret (
  one {INTEGER} NOT NULL PRIMARY KEY CHECK (one = 1),
  secret {TEXT} NOT NULL CHECK (length(secret) = 64)
) {STRICT};

-- What vouches for an ended attempt (AttemptProof); without a row nothing does. accepted_by: the person; '' for others.
CREATE TABLE proofs (
  attempt {TEXT} NOT NULL PRIMARY KEY REFERENCES attempts (id),
  state {TEXT} NOT NULL CHECK (state IN ('unproven', 'proven', 'accepted', 'earlier', 'demonstration')),
  accepted_by {TEXT} NOT NULL,
  CHECK ((state = 'accepted') = (accepted_by <> ''))
) {STRICT};

-- Attempts that were kept before there were proofs count as they did.
INSERT INTO proofs SELECT id, 'earlier', '' FROM attempts WHERE state <> 'open' AND crashed = 0;
