-- Facts stay as they are, whoever asks.

CREATE TRIGGER attempts_stay BEFORE DELETE ON attempts
BEGIN
  SELECT RAISE(ABORT, 'An attempt is not deleted: void it.');
END;

-- REPLACE deletes without a word where recursive triggers are off.
CREATE TRIGGER attempts_come_once BEFORE INSERT ON attempts
WHEN EXISTS (SELECT 1 FROM attempts WHERE id = NEW.id OR arrival = NEW.arrival)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: attempts.');
END;

CREATE TRIGGER forms_stay BEFORE DELETE ON forms
BEGIN
  SELECT RAISE(ABORT, 'A form that was filled in is not deleted.');
END;

-- REPLACE deletes without a word where recursive triggers are off.
CREATE TRIGGER forms_come_once BEFORE INSERT ON forms
WHEN EXISTS (SELECT 1 FROM forms WHERE id = NEW.id OR arrival = NEW.arrival)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: forms.');
END;

CREATE TRIGGER curricula_stay BEFORE DELETE ON curricula
BEGIN
  SELECT RAISE(ABORT, 'A published curriculum is not deleted.');
END;

-- REPLACE deletes without a word where recursive triggers are off.
CREATE TRIGGER curricula_come_once BEFORE INSERT ON curricula
WHEN EXISTS (SELECT 1 FROM curricula WHERE name = NEW.name AND version = NEW.version)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: curricula.');
END;

CREATE TRIGGER audit_stay BEFORE DELETE ON audit
BEGIN
  SELECT RAISE(ABORT, 'The audit log is not shortened.');
END;

-- REPLACE deletes without a word where recursive triggers are off.
CREATE TRIGGER audit_come_once BEFORE INSERT ON audit
WHEN EXISTS (SELECT 1 FROM audit WHERE number = NEW.number)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: audit.');
END;

CREATE TRIGGER forms_fixed BEFORE UPDATE ON forms
BEGIN
  SELECT RAISE(ABORT, 'A form that was filled in is not changed: fill in another.');
END;

CREATE TRIGGER curricula_fixed BEFORE UPDATE ON curricula
BEGIN
  SELECT RAISE(ABORT, 'A published curriculum is not changed: publish another version.');
END;

CREATE TRIGGER audit_fixed BEFORE UPDATE ON audit
BEGIN
  SELECT RAISE(ABORT, 'The audit log is not changed.');
END;

-- Begun once; ended once, or once more after it was told abandoned by a crash; voided once.
CREATE TRIGGER attempts_fixed BEFORE UPDATE ON attempts
WHEN
    (NEW.id, NEW.person, NEW.run, NEW.curriculum, NEW.curriculum_version, NEW.level, NEW.procedure,
    NEW.procedure_version, NEW.case_name, NEW.case_hash, NEW.workstation, NEW.begun_us, NEW.arrival) IS NOT
    (OLD.id, OLD.person, OLD.run, OLD.curriculum, OLD.curriculum_version, OLD.level, OLD.procedure,
    OLD.procedure_version, OLD.case_name, OLD.case_hash, OLD.workstation, OLD.begun_us, OLD.arrival)
  OR (
    (NEW.state, NEW.crashed, NEW.length_us, NEW.succeeded, NEW.critical_errors, NEW.points, NEW.metrics,
    NEW.recording, NEW.recording_hash) IS NOT (OLD.state, OLD.crashed, OLD.length_us, OLD.succeeded,
    OLD.critical_errors, OLD.points, OLD.metrics, OLD.recording, OLD.recording_hash)
    AND NOT (NEW.state <> 'open' AND (OLD.state = 'open' OR (OLD.crashed = 1 AND NEW.crashed = 0))))
  OR (
    (NEW.voided_us, NEW.voided_by, NEW.void_reason) IS NOT (OLD.voided_us, OLD.voided_by, OLD.void_reason)
    AND OLD.voided_us IS NOT NULL)
BEGIN
  SELECT RAISE(ABORT, 'An attempt is not changed once it has ended: void it.');
END;
