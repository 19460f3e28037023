-- An opening is written and closed once each.
CREATE TRIGGER openings_stay BEFORE DELETE ON openings
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('An opening of a test is not deleted: close it.');
CREATE TRIGGER openings_stay_all BEFORE TRUNCATE ON openings
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('An opening of a test is not deleted: close it.');
CREATE TRIGGER openings_fixed BEFORE UPDATE ON openings FOR EACH ROW
WHEN ((NEW.id, NEW.cohort, NEW.curriculum, NEW.level, NEW.start_us, NEW.end_us, NEW.code, NEW.opened_by, NEW.opened_us)
  IS DISTINCT FROM (OLD.id, OLD.cohort, OLD.curriculum, OLD.level, OLD.start_us, OLD.end_us, OLD.code, OLD.opened_by,
  OLD.opened_us) OR OLD.closed_us IS NOT NULL)
  EXECUTE FUNCTION insonate_refuse('An opening of a test can be closed, once, but not changed.');
CREATE TRIGGER opening_entries_stay BEFORE DELETE ON opening_entries
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A code that was entered stays entered.');
CREATE TRIGGER opening_entries_stay_all BEFORE TRUNCATE ON opening_entries
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('A code that was entered stays entered.');
CREATE TRIGGER opening_entries_fixed BEFORE UPDATE ON opening_entries
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A code that was entered stays entered.');
CREATE TRIGGER attempts_sitting_fixed BEFORE UPDATE ON attempts FOR EACH ROW
WHEN (NEW.sitting IS DISTINCT FROM OLD.sitting AND OLD.sitting <> 'undecided')
  EXECUTE FUNCTION insonate_refuse('Whether a test was open for an attempt is decided once.');
