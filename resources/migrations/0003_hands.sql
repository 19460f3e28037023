-- The movements by which attempts were made, so that a recording counts once, whoever brings it and under whatever name.
-- hash: AttemptFacts::handsHash; since_us: when the attempt that it belongs to was added.
CREATE TABLE hands (
  hash {TEXT} NOT NULL PRIMARY KEY CHECK (length(hash) = 64),
  attempt {TEXT} NOT NULL REFERENCES attempts (id),
  since_us {INTEGER} NOT NULL
) {STRICT};
CREATE INDEX hands_by_attempt ON hands (attempt);
