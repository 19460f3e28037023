CREATE TRIGGER erasures_stay BEFORE DELETE ON erasures
BEGIN
  SELECT RAISE(ABORT, 'A person who was erased stays erased.');
END;

-- REPLACE deletes without a word where recursive triggers are off.
CREATE TRIGGER erasures_come_once BEFORE INSERT ON erasures
WHEN EXISTS (SELECT 1 FROM erasures WHERE person = NEW.person)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: erasures.');
END;

CREATE TRIGGER erasures_fixed BEFORE UPDATE ON erasures
BEGIN
  SELECT RAISE(ABORT, 'A person who was erased stays erased.');
END;

-- As before, but the detail of an entry may be erased. The check of the log demands a later entry that vouches for the
-- other fields (AuditChain.h).
DROP TRIGGER audit_fixed;
CREATE TRIGGER audit_fixed BEFORE UPDATE ON audit
WHEN NOT ((NEW.number, NEW.time_us, NEW.actor, NEW.workstation, NEW.act, NEW.person, NEW.allowed, NEW.hash) IS
  (OLD.number, OLD.time_us, OLD.actor, OLD.workstation, OLD.act, OLD.person, OLD.allowed, OLD.hash)
  AND NEW.detail LIKE '(erased)%')
BEGIN
  SELECT RAISE(ABORT, 'The audit log is not changed.');
END;

-- As before, but the answers about a person who was erased lose their texts.
DROP TRIGGER forms_fixed;
CREATE TRIGGER forms_fixed BEFORE UPDATE ON forms
WHEN NOT ((NEW.arrival, NEW.id, NEW.form, NEW.form_version, NEW.person, NEW.attempt, NEW.filled_by, NEW.filled_us) IS
  (OLD.arrival, OLD.id, OLD.form, OLD.form_version, OLD.person, OLD.attempt, OLD.filled_by, OLD.filled_us)
  AND EXISTS (SELECT 1 FROM erasures WHERE erasures.person = OLD.person))
BEGIN
  SELECT RAISE(ABORT, 'A form that was filled in is not changed: fill in another.');
END;

-- As before, but for the name of the recording and the reason of voiding, which have a trigger of their own.
DROP TRIGGER attempts_fixed;
CREATE TRIGGER attempts_fixed BEFORE UPDATE ON attempts
WHEN
    (NEW.id, NEW.person, NEW.run, NEW.curriculum, NEW.curriculum_version, NEW.level, NEW.procedure,
    NEW.procedure_version, NEW.case_name, NEW.case_hash, NEW.workstation, NEW.begun_us, NEW.arrival) IS NOT
    (OLD.id, OLD.person, OLD.run, OLD.curriculum, OLD.curriculum_version, OLD.level, OLD.procedure,
    OLD.procedure_version, OLD.case_name, OLD.case_hash, OLD.workstation, OLD.begun_us, OLD.arrival)
  OR (
    (NEW.state, NEW.crashed, NEW.length_us, NEW.succeeded, NEW.critical_errors, NEW.points, NEW.metrics,
    NEW.recording_hash) IS NOT (OLD.state, OLD.crashed, OLD.length_us, OLD.succeeded,
    OLD.critical_errors, OLD.points, OLD.metrics, OLD.recording_hash)
    AND NOT (NEW.state <> 'open' AND (OLD.state = 'open' OR (OLD.crashed = 1 AND NEW.crashed = 0))))
  OR (
    (NEW.voided_us, NEW.voided_by) IS NOT (OLD.voided_us, OLD.voided_by)
    AND OLD.voided_us IS NOT NULL)
BEGIN
  SELECT RAISE(ABORT, 'An attempt is not changed once it has ended: void it.');
END;

CREATE TRIGGER attempts_texts_fixed BEFORE UPDATE ON attempts
WHEN (
    (NEW.recording IS NOT OLD.recording
    AND NOT (NEW.state <> 'open' AND (OLD.state = 'open' OR (OLD.crashed = 1 AND NEW.crashed = 0))))
  OR (NEW.void_reason IS NOT OLD.void_reason AND OLD.voided_us IS NOT NULL))
  AND NOT (EXISTS (SELECT 1 FROM erasures WHERE erasures.person = OLD.person)
  AND NEW.recording IN (OLD.recording, '')
  AND COALESCE(NEW.void_reason, '') IN (COALESCE(OLD.void_reason, ''), '(erased)'))
BEGIN
  SELECT RAISE(ABORT, 'An attempt is not changed once it has ended: void it.');
END;
