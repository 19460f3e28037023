-- A recording that was counted stays counted.
CREATE TRIGGER hands_stay BEFORE DELETE ON hands
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A recording that was counted stays counted.');
CREATE TRIGGER hands_stay_all BEFORE TRUNCATE ON hands
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('A recording that was counted stays counted.');
CREATE TRIGGER hands_fixed BEFORE UPDATE ON hands
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A recording that was counted stays counted.');
