-- People who were erased on request: their rows stay under a pseudonym, without their texts. The account stays disabled.
CREATE TABLE erasures (
  person {TEXT} NOT NULL PRIMARY KEY REFERENCES people (id),
  erased_us {INTEGER} NOT NULL,
  erased_by {TEXT} NOT NULL
) {STRICT};
