-- By a token a computer keeps a person signed in. hash: SHA-256 of the token, hexadecimal; version: that of the password
-- when the token was made, so that another password ends it.
CREATE TABLE sign_in_tokens (
  hash {TEXT} NOT NULL PRIMARY KEY CHECK (length(hash) = 64),
  person {TEXT} NOT NULL REFERENCES people (id),
  version {INTEGER} NOT NULL,
  made_us {INTEGER} NOT NULL
) {STRICT};
CREATE INDEX sign_in_tokens_by_person ON sign_in_tokens (person);
