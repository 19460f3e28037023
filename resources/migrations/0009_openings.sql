-- Openings of tests (TestOpening). cohort: '' for everyone; end_us: NULL until it is closed; code: hash (argon2id) of the
-- code that trainees enter, '' for none. Fetched from the server as they are there.
CREATE TABLE openings (
  id {TEXT} NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  cohort {TEXT} NOT NULL,
  curriculum {TEXT} NOT NULL,
  level {TEXT} NOT NULL,
  start_us {INTEGER} NOT NULL,
  end_us {INTEGER},
  code {TEXT} NOT NULL,
  opened_by {TEXT} NOT NULL,
  opened_us {INTEGER} NOT NULL,
  closed_by {TEXT},
  closed_us {INTEGER},
  CHECK (end_us IS NULL OR end_us > start_us),
  CHECK (end_us IS NOT NULL OR code <> ''),
  CHECK ((closed_us IS NULL) = (closed_by IS NULL))
) {STRICT};
CREATE INDEX openings_by_level ON openings (curriculum, level);

-- Trainees who entered the code of an opening.
CREATE TABLE opening_entries (
  opening {TEXT} NOT NULL REFERENCES openings (id),
  person {TEXT} NOT NULL REFERENCES people (id),
  entered_us {INTEGER} NOT NULL,
  PRIMARY KEY (opening, person)
) {STRICT};

-- AttemptFacts::sitting. Attempts of earlier programs count as they did.
ALTER TABLE attempts ADD COLUMN sitting {TEXT} NOT NULL DEFAULT 'earlier'
  CHECK (sitting IN ('none', 'earlier', 'opened', 'self', 'practice', 'undecided'));
