-- The rule by which old data are deleted (RetentionRule). Months; NULL: never. waits_us: when the rule was set, applied or
-- put off; one of the servers applies it a day later. applied_us: when this rule was last applied; 0: not yet.
CREATE TABLE retention (
  one {INTEGER} NOT NULL PRIMARY KEY CHECK (one = 1),
  erase_months {INTEGER} CHECK (erase_months > 0),
  recording_months {INTEGER} CHECK (recording_months > 0),
  set_us {INTEGER} NOT NULL,
  waits_us {INTEGER} NOT NULL,
  applied_us {INTEGER} NOT NULL
) {STRICT};
INSERT INTO retention VALUES (1, NULL, NULL, 0, 0, 0);
