-- Archived cohorts (classes) stay readable; they take neither new members nor openings of tests.
ALTER TABLE cohorts ADD COLUMN archived {INTEGER} NOT NULL DEFAULT 0 CHECK (archived IN (0, 1));
