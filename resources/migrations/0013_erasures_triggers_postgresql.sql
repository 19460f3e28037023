CREATE TRIGGER erasures_stay BEFORE DELETE ON erasures
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A person who was erased stays erased.');
CREATE TRIGGER erasures_stay_all BEFORE TRUNCATE ON erasures
  FOR EACH STATEMENT EXECUTE FUNCTION insonate_refuse('A person who was erased stays erased.');
CREATE TRIGGER erasures_fixed BEFORE UPDATE ON erasures
  FOR EACH ROW EXECUTE FUNCTION insonate_refuse('A person who was erased stays erased.');

-- As before, but the detail of an entry may be erased. The check of the log demands a later entry that vouches for the
-- other fields (AuditChain.h).
DROP TRIGGER audit_fixed ON audit;
CREATE TRIGGER audit_fixed BEFORE UPDATE ON audit FOR EACH ROW
WHEN (NOT ((NEW.number, NEW.time_us, NEW.actor, NEW.workstation, NEW.act, NEW.person, NEW.allowed, NEW.hash) IS NOT
  DISTINCT FROM (OLD.number, OLD.time_us, OLD.actor, OLD.workstation, OLD.act, OLD.person, OLD.allowed, OLD.hash)
  AND NEW.detail LIKE '(erased)%'))
  EXECUTE FUNCTION insonate_refuse('The audit log is not changed.');

-- The condition of a trigger cannot read another table.
CREATE FUNCTION insonate_refuse_unless_erased() RETURNS trigger LANGUAGE plpgsql AS $$
BEGIN
  IF EXISTS (SELECT 1 FROM erasures WHERE erasures.person = OLD.person) THEN
    RETURN NEW;
  END IF;
  RAISE EXCEPTION '%', TG_ARGV[0];
END $$;

-- As before, but the answers about a person who was erased lose their texts.
DROP TRIGGER forms_fixed ON forms;
CREATE TRIGGER forms_fixed BEFORE UPDATE ON forms FOR EACH ROW
WHEN ((NEW.arrival, NEW.id, NEW.form, NEW.form_version, NEW.person, NEW.attempt, NEW.filled_by, NEW.filled_us) IS
  DISTINCT FROM (OLD.arrival, OLD.id, OLD.form, OLD.form_version, OLD.person, OLD.attempt, OLD.filled_by,
  OLD.filled_us))
  EXECUTE FUNCTION insonate_refuse('A form that was filled in is not changed: fill in another.');
CREATE TRIGGER forms_texts_fixed BEFORE UPDATE ON forms FOR EACH ROW
WHEN (NEW.answers IS DISTINCT FROM OLD.answers)
  EXECUTE FUNCTION insonate_refuse_unless_erased('A form that was filled in is not changed: fill in another.');

-- As before, but for the name of the recording and the reason of voiding, which have triggers of their own.
DROP TRIGGER attempts_fixed ON attempts;
CREATE TRIGGER attempts_fixed BEFORE UPDATE ON attempts FOR EACH ROW
WHEN (
    (NEW.id, NEW.person, NEW.run, NEW.curriculum, NEW.curriculum_version, NEW.level, NEW.procedure,
    NEW.procedure_version, NEW.case_name, NEW.case_hash, NEW.workstation, NEW.begun_us, NEW.arrival) IS
    DISTINCT FROM (OLD.id, OLD.person, OLD.run, OLD.curriculum, OLD.curriculum_version, OLD.level,
    OLD.procedure, OLD.procedure_version, OLD.case_name, OLD.case_hash, OLD.workstation, OLD.begun_us,
    OLD.arrival)
  OR (
    (NEW.state, NEW.crashed, NEW.length_us, NEW.succeeded, NEW.critical_errors, NEW.points, NEW.metrics,
    NEW.recording_hash) IS DISTINCT FROM (OLD.state, OLD.crashed, OLD.length_us, OLD.succeeded,
    OLD.critical_errors, OLD.points, OLD.metrics, OLD.recording_hash)
    AND NOT (NEW.state <> 'open' AND (OLD.state = 'open' OR (OLD.crashed = 1 AND NEW.crashed = 0))))
  OR (
    (NEW.voided_us, NEW.voided_by) IS DISTINCT FROM (OLD.voided_us, OLD.voided_by)
    AND OLD.voided_us IS NOT NULL))
  EXECUTE FUNCTION insonate_refuse('An attempt is not changed once it has ended: void it.');
CREATE TRIGGER attempts_texts_fixed BEFORE UPDATE ON attempts FOR EACH ROW
WHEN (
    (NEW.recording IS DISTINCT FROM OLD.recording AND NEW.recording <> ''
    AND NOT (NEW.state <> 'open' AND (OLD.state = 'open' OR (OLD.crashed = 1 AND NEW.crashed = 0))))
  OR (NEW.void_reason IS DISTINCT FROM OLD.void_reason AND COALESCE(NEW.void_reason, '') <> '(erased)'
    AND OLD.voided_us IS NOT NULL))
  EXECUTE FUNCTION insonate_refuse('An attempt is not changed once it has ended: void it.');
CREATE TRIGGER attempts_texts_erased BEFORE UPDATE ON attempts FOR EACH ROW
WHEN (
    (NEW.recording IS DISTINCT FROM OLD.recording
    AND NOT (NEW.state <> 'open' AND (OLD.state = 'open' OR (OLD.crashed = 1 AND NEW.crashed = 0))))
  OR (NEW.void_reason IS DISTINCT FROM OLD.void_reason AND OLD.voided_us IS NOT NULL))
  EXECUTE FUNCTION insonate_refuse_unless_erased('An attempt is not changed once it has ended: void it.');
