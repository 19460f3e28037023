-- Facts stay as they are, whoever asks.

CREATE FUNCTION insonate_refuse() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  RAISE EXCEPTION '%', TG_ARGV[0];
END $$;

CREATE TRIGGER attempts_stay BEFORE DELETE ON attempts
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('An attempt is not deleted: void it.');
CREATE TRIGGER attempts_stay_all BEFORE TRUNCATE ON attempts
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('An attempt is not deleted: void it.');

CREATE TRIGGER forms_stay BEFORE DELETE ON forms
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A form that was filled in is not deleted.');
CREATE TRIGGER forms_stay_all BEFORE TRUNCATE ON forms
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('A form that was filled in is not deleted.');

CREATE TRIGGER curricula_stay BEFORE DELETE ON curricula
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A published curriculum is not deleted.');
CREATE TRIGGER curricula_stay_all BEFORE TRUNCATE ON curricula
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('A published curriculum is not deleted.');

CREATE TRIGGER audit_stay BEFORE DELETE ON audit
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('The audit log is not shortened.');
CREATE TRIGGER audit_stay_all BEFORE TRUNCATE ON audit
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('The audit log is not shortened.');

CREATE TRIGGER forms_fixed BEFORE UPDATE ON forms
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A form that was filled in is not changed: fill in another.');

CREATE TRIGGER curricula_fixed BEFORE UPDATE ON curricula
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A published curriculum is not changed: publish another version.');

CREATE TRIGGER audit_fixed BEFORE UPDATE ON audit
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('The audit log is not changed.');

-- Begun once; ended once, or once more after it was told abandoned by a crash; voided once.
CREATE TRIGGER attempts_fixed BEFORE UPDATE ON attempts FOR EACH ROW
WHEN (
    (NEW.id, NEW.person, NEW.run, NEW.curriculum, NEW.curriculum_version, NEW.level, NEW.procedure,
    NEW.procedure_version, NEW.case_name, NEW.case_hash, NEW.workstation, NEW.begun_us, NEW.arrival) IS
    DISTINCT FROM (OLD.id, OLD.person, OLD.run, OLD.curriculum, OLD.curriculum_version, OLD.level,
    OLD.procedure, OLD.procedure_version, OLD.case_name, OLD.case_hash, OLD.workstation, OLD.begun_us,
    OLD.arrival)
  OR (
    (NEW.state, NEW.crashed, NEW.length_us, NEW.succeeded, NEW.critical_errors, NEW.points, NEW.metrics,
    NEW.recording, NEW.recording_hash) IS DISTINCT FROM (OLD.state, OLD.crashed, OLD.length_us, OLD.succeeded,
    OLD.critical_errors, OLD.points, OLD.metrics, OLD.recording, OLD.recording_hash)
    AND NOT (NEW.state <> 'open' AND (OLD.state = 'open' OR (OLD.crashed = 1 AND NEW.crashed = 0))))
  OR (
    (NEW.voided_us, NEW.voided_by, NEW.void_reason) IS DISTINCT FROM (OLD.voided_us, OLD.voided_by,
    OLD.void_reason)
    AND OLD.voided_us IS NOT NULL))
  EXECUTE FUNCTION insonate_refuse('An attempt is not changed once it has ended: void it.');
