-- Workstations that may send attempts to this database through its server. token_hash: SHA-256 of the workstation's
-- token, hexadecimal. store_secret: the secret of the workstation's own store, by which the server checks the nonces of
-- its recordings; empty until the workstation has connected for the first time.
CREATE TABLE workstations (
  name {TEXT} NOT NULL PRIMARY KEY,
  token_hash {TEXT} NOT NULL UNIQUE CHECK (length(token_hash) = 64),
  added_by {TEXT} NOT NULL REFERENCES people (id),
  added_us {INTEGER} NOT NULL,
  seen_us {INTEGER},
  revoked_us {INTEGER},
  store_secret {TEXT} NOT NULL CHECK (length(store_secret) IN (0, 64))
) {STRICT};

-- People who have signed in to the server at a workstation: it may send their attempts, and receives their data.
CREATE TABLE workstation_people (
  workstation {TEXT} NOT NULL REFERENCES workstations (name),
  person {TEXT} NOT NULL REFERENCES people (id),
  since_us {INTEGER} NOT NULL,
  PRIMARY KEY (workstation, person)
) {STRICT};

-- Attempts of workstations that the server verifies: it computes them again from their recordings. taken_us: when a
-- server began with it; why: the reason if the attempt was not verified.
CREATE TABLE verifications (
  attempt {TEXT} NOT NULL PRIMARY KEY REFERENCES attempts (id),
  since_us {INTEGER} NOT NULL,
  received_us {INTEGER},
  taken_us {INTEGER},
  ended_us {INTEGER},
  why {TEXT} NOT NULL
) {STRICT};
CREATE INDEX verifications_that_wait ON verifications (ended_us, received_us);
