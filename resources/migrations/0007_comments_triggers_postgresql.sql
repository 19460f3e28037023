-- A comment is written, read and removed once each.
CREATE TRIGGER comments_stay BEFORE DELETE ON comments
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A comment stays, with or without its text.');
CREATE TRIGGER comments_stay_all BEFORE TRUNCATE ON comments
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('A comment stays, with or without its text.');
CREATE TRIGGER comments_fixed BEFORE UPDATE ON comments FOR EACH ROW
WHEN (NOT (NEW.id = OLD.id AND NEW.attempt = OLD.attempt AND NEW.at_us = OLD.at_us AND NEW.author = OLD.author
  AND NEW.written_us = OLD.written_us AND OLD.removed_us IS NULL
  AND (OLD.read_us IS NULL OR COALESCE(NEW.read_us, -1) = OLD.read_us)
  AND (NEW.text = OLD.text OR NEW.removed_us IS NOT NULL)))
  EXECUTE FUNCTION insonate_refuse('A comment can be read and removed, but not changed.');
