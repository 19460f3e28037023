-- A recording that was counted stays counted.
CREATE TRIGGER hands_stay BEFORE DELETE ON hands
BEGIN
  SELECT RAISE(ABORT, 'A recording that was counted stays counted.');
END;

-- REPLACE deletes without a word where recursive triggers are off.
CREATE TRIGGER hands_come_once BEFORE INSERT ON hands
WHEN EXISTS (SELECT 1 FROM hands WHERE hash = NEW.hash)
BEGIN
  SELECT RAISE(ABORT, 'It is there already: hands.');
END;

CREATE TRIGGER hands_fixed BEFORE UPDATE ON hands
BEGIN
  SELECT RAISE(ABORT, 'A recording that was counted stays counted.');
END;
