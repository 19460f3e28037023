-- Comments of instructors at a time of an attempt's recording (AttemptComment). at_us: from the begin of the recording;
-- read_us: when the trainee first read it. A removed comment keeps its row without its text.
CREATE TABLE comments (
  id {TEXT} NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  attempt {TEXT} NOT NULL REFERENCES attempts (id),
  at_us {INTEGER} NOT NULL CHECK (at_us >= 0),
  author {TEXT} NOT NULL,
  written_us {INTEGER} NOT NULL,
  text {TEXT} NOT NULL,
  read_us {INTEGER},
  removed_us {INTEGER},
  removed_by {TEXT},
  CHECK ((removed_us IS NULL) = (removed_by IS NULL)),
  CHECK ((removed_us IS NULL) = (text <> ''))
) {STRICT};
CREATE INDEX comments_by_attempt ON comments (attempt, at_us);
