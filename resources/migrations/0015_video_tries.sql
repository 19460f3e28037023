-- Number of times that a server has begun the video and not ended it. A recording that makes servers fail is given up.
ALTER TABLE videos ADD COLUMN tries {INTEGER} NOT NULL DEFAULT 0;
