-- What a class's page tells of each, so that it need not be worked out from all attempts for each look: what concerns,
-- and from when until when it holds though nothing is done. rules: kStandingRules of the program that worked it out.
DROP TABLE standings;
CREATE TABLE standings (
  person {TEXT} NOT NULL REFERENCES people (id),
  curriculum {TEXT} NOT NULL,
  curriculum_version {INTEGER} NOT NULL,
  level {TEXT} NOT NULL,
  mastered {INTEGER} NOT NULL,
  concern {TEXT} NOT NULL,
  sentence {TEXT} NOT NULL,
  changes {INTEGER} NOT NULL,
  from_us {INTEGER} NOT NULL,
  until_us {INTEGER} NOT NULL,
  rules {INTEGER} NOT NULL,
  PRIMARY KEY (person, curriculum, curriculum_version)
) {STRICT};

-- Whose attempt is the recording that is opened?
CREATE INDEX attempts_by_recording_hash ON attempts (recording_hash);
CREATE INDEX attempts_by_recording ON attempts (workstation, recording, arrival);
