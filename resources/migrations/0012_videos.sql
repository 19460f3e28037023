-- Videos of attempts that users requested, which a server makes from the recordings. taken_us: when the server that
-- makes it last reported, under the name taken_by; permille: how much of it is done; ended_us: when it was done; why:
-- the reason if it could not be made. The files are in a folder of the servers.
CREATE TABLE videos (
  attempt {TEXT} NOT NULL PRIMARY KEY REFERENCES attempts (id),
  asked_us {INTEGER} NOT NULL,
  begun_us {INTEGER},
  taken_us {INTEGER},
  taken_by {TEXT} NOT NULL,
  permille {INTEGER} NOT NULL,
  ended_us {INTEGER},
  why {TEXT} NOT NULL
) {STRICT};
CREATE INDEX videos_that_wait ON videos (ended_us, asked_us);
