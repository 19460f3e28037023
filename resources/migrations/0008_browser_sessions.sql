-- Sessions of people who use the pages of a server in a browser. hash: SHA-256 of the secret in the browser's cookie,
-- hexadecimal; version: that of the password when the session was begun, so that another password ends it.
CREATE TABLE browser_sessions (
  hash {TEXT} NOT NULL PRIMARY KEY CHECK (length(hash) = 64),
  person {TEXT} NOT NULL REFERENCES people (id),
  version {INTEGER} NOT NULL,
  begun_us {INTEGER} NOT NULL,
  used_us {INTEGER} NOT NULL
) {STRICT};
CREATE INDEX browser_sessions_by_person ON browser_sessions (person);
