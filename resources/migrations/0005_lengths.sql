-- Which earlier attempt has the values of this one? The same values take the same time.
CREATE INDEX attempts_by_length ON attempts (length_us);
