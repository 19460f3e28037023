-- An opening is written and closed once each.
CREATE TRIGGER openings_stay BEFORE DELETE ON openings
BEGIN
  SELECT RAISE(ABORT, 'An opening of a test is not deleted: close it.');
END;

-- REPLACE deletes without a word where recursive triggers are off.
CREATE TRIGGER openings_come_once BEFORE INSERT ON openings
WHEN EXISTS (SELECT 1 FROM openings WHERE id = NEW.id)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: openings.');
END;

CREATE TRIGGER openings_fixed BEFORE UPDATE ON openings
WHEN (NEW.id, NEW.cohort, NEW.curriculum, NEW.level, NEW.start_us, NEW.end_us, NEW.code, NEW.opened_by, NEW.opened_us)
  IS NOT (OLD.id, OLD.cohort, OLD.curriculum, OLD.level, OLD.start_us, OLD.end_us, OLD.code, OLD.opened_by,
  OLD.opened_us) OR OLD.closed_us IS NOT NULL
BEGIN
  SELECT RAISE(ABORT, 'An opening of a test can be closed, once, but not changed.');
END;

CREATE TRIGGER opening_entries_stay BEFORE DELETE ON opening_entries
BEGIN
  SELECT RAISE(ABORT, 'A code that was entered stays entered.');
END;

CREATE TRIGGER opening_entries_come_once BEFORE INSERT ON opening_entries
WHEN EXISTS (SELECT 1 FROM opening_entries WHERE opening = NEW.opening AND person = NEW.person)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: opening_entries.');
END;

CREATE TRIGGER opening_entries_fixed BEFORE UPDATE ON opening_entries
BEGIN
  SELECT RAISE(ABORT, 'A code that was entered stays entered.');
END;

CREATE TRIGGER attempts_sitting_fixed BEFORE UPDATE ON attempts
WHEN NEW.sitting IS NOT OLD.sitting AND OLD.sitting <> 'undecided'
BEGIN
  SELECT RAISE(ABORT, 'Whether a test was open for an attempt is decided once.');
END;
