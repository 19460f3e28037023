-- A comment is written, read and removed once each.
CREATE TRIGGER comments_stay BEFORE DELETE ON comments
BEGIN
  SELECT RAISE(ABORT, 'A comment stays, with or without its text.');
END;

-- REPLACE deletes without a word where recursive triggers are off.
CREATE TRIGGER comments_come_once BEFORE INSERT ON comments
WHEN EXISTS (SELECT 1 FROM comments WHERE id = NEW.id)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: comments.');
END;

CREATE TRIGGER comments_fixed BEFORE UPDATE ON comments
WHEN NOT (NEW.id = OLD.id AND NEW.attempt = OLD.attempt AND NEW.at_us = OLD.at_us AND NEW.author = OLD.author
  AND NEW.written_us = OLD.written_us AND OLD.removed_us IS NULL
  AND (OLD.read_us IS NULL OR COALESCE(NEW.read_us, -1) = OLD.read_us)
  AND (NEW.text = OLD.text OR NEW.removed_us IS NOT NULL))
BEGIN
  SELECT RAISE(ABORT, 'A comment can be read and removed, but not changed.');
END;
