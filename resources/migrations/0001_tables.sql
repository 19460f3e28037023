-- What a store keeps. {INTEGER}, {REAL}, {TEXT} and {STRICT} are spelled by each database's dialect; times are
-- microseconds since 1970, UTC; truth is 0 or 1; ids are UUIDs.

CREATE TABLE people (
  id {TEXT} NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  name {TEXT} NOT NULL,
  name_key {TEXT} NOT NULL UNIQUE,
  full_name {TEXT} NOT NULL,
  email {TEXT} NOT NULL,
  role {TEXT} NOT NULL CHECK (role IN ('trainee', 'instructor', 'administrator')),
  disabled {INTEGER} NOT NULL CHECK (disabled IN (0, 1))
) {STRICT};

-- version grows with each new password, and ends sessions that began with the one before.
CREATE TABLE credentials (
  person {TEXT} NOT NULL PRIMARY KEY REFERENCES people (id),
  password {TEXT} NOT NULL,
  must_change {INTEGER} NOT NULL CHECK (must_change IN (0, 1)),
  version {INTEGER} NOT NULL
) {STRICT};

-- By the hash of the name that was tried, whether it exists or not. up_us: since the computer's boot.
CREATE TABLE sign_in_failures (
  name_hash {TEXT} NOT NULL PRIMARY KEY,
  failures {INTEGER} NOT NULL,
  last_us {INTEGER} NOT NULL,
  boot {TEXT} NOT NULL,
  up_us {INTEGER} NOT NULL
) {STRICT};

CREATE TABLE cohorts (
  id {TEXT} NOT NULL PRIMARY KEY CHECK (length(id) = 36),
  name {TEXT} NOT NULL,
  name_key {TEXT} NOT NULL UNIQUE,
  curriculum {TEXT} NOT NULL,
  curriculum_version {INTEGER} NOT NULL
) {STRICT};

CREATE TABLE memberships (
  cohort {TEXT} NOT NULL REFERENCES cohorts (id),
  person {TEXT} NOT NULL REFERENCES people (id),
  teaches {INTEGER} NOT NULL CHECK (teaches IN (0, 1)),
  PRIMARY KEY (cohort, person)
) {STRICT};
CREATE INDEX memberships_by_person ON memberships (person, teaches, cohort);

CREATE TABLE curricula (
  name {TEXT} NOT NULL,
  version {INTEGER} NOT NULL CHECK (version > 0),
  text {TEXT} NOT NULL,
  hash {TEXT} NOT NULL CHECK (length(hash) = 64),
  published_us {INTEGER} NOT NULL,
  published_by {TEXT} NOT NULL,
  PRIMARY KEY (name, version)
) {STRICT};

CREATE TABLE drafts (
  name {TEXT} NOT NULL PRIMARY KEY,
  text {TEXT} NOT NULL
) {STRICT};

-- Processes that began attempts, to tell which of them have died.
CREATE TABLE runs (
  id {TEXT} NOT NULL PRIMARY KEY,
  workstation {TEXT} NOT NULL,
  machine {TEXT} NOT NULL,
  boot {TEXT} NOT NULL,
  pid {INTEGER} NOT NULL,
  started {INTEGER} NOT NULL
) {STRICT};

-- A row is begun, ended, perhaps voided; triggers refuse any other change. run is '' where it came from a workstation.
CREATE TABLE attempts (
  arrival {INTEGER} NOT NULL PRIMARY KEY,
  id {TEXT} NOT NULL UNIQUE CHECK (length(id) = 36),
  person {TEXT} NOT NULL REFERENCES people (id),
  run {TEXT} NOT NULL,
  curriculum {TEXT} NOT NULL,
  curriculum_version {INTEGER} NOT NULL,
  level {TEXT} NOT NULL,
  procedure {TEXT} NOT NULL,
  procedure_version {INTEGER} NOT NULL,
  case_name {TEXT} NOT NULL,
  case_hash {TEXT} NOT NULL,
  workstation {TEXT} NOT NULL,
  begun_us {INTEGER} NOT NULL,
  state {TEXT} NOT NULL CHECK (state IN ('open', 'completed', 'abandoned')),
  crashed {INTEGER} NOT NULL CHECK (crashed IN (0, 1)),
  length_us {INTEGER} NOT NULL CHECK (length_us >= 0),
  succeeded {INTEGER} NOT NULL CHECK (succeeded IN (0, 1)),
  critical_errors {INTEGER} NOT NULL CHECK (critical_errors >= 0),
  points {REAL} CHECK (points BETWEEN 0 AND 100),
  metrics {TEXT} NOT NULL,
  recording {TEXT} NOT NULL,
  recording_hash {TEXT} NOT NULL,
  voided_us {INTEGER},
  voided_by {TEXT},
  void_reason {TEXT},
  CHECK (crashed = 0 OR state = 'abandoned'),
  CHECK (voided_us IS NULL OR state <> 'open')
) {STRICT};
CREATE INDEX attempts_by_person ON attempts (person, arrival, state, crashed, voided_us, begun_us, level);
CREATE INDEX attempts_open ON attempts (run) WHERE state = 'open';

CREATE TABLE forms (
  arrival {INTEGER} NOT NULL PRIMARY KEY,
  id {TEXT} NOT NULL UNIQUE CHECK (length(id) = 36),
  form {TEXT} NOT NULL,
  form_version {INTEGER} NOT NULL,
  person {TEXT} NOT NULL REFERENCES people (id),
  attempt {TEXT} REFERENCES attempts (id),
  filled_by {TEXT} NOT NULL REFERENCES people (id),
  filled_us {INTEGER} NOT NULL,
  answers {TEXT} NOT NULL
) {STRICT};
CREATE INDEX forms_by_person ON forms (person, arrival);
CREATE INDEX forms_by_attempt ON forms (attempt, arrival);

-- What was worked out from attempts; no fact, can be deleted.
CREATE TABLE standings (
  person {TEXT} NOT NULL REFERENCES people (id),
  curriculum {TEXT} NOT NULL,
  curriculum_version {INTEGER} NOT NULL,
  level {TEXT} NOT NULL,
  mastered {INTEGER} NOT NULL,
  sentence {TEXT} NOT NULL,
  changes {INTEGER} NOT NULL,
  PRIMARY KEY (person, curriculum, curriculum_version)
) {STRICT};

-- What waits for the server. A change of what waits already takes a new number.
CREATE TABLE outbox (
  number {INTEGER} NOT NULL PRIMARY KEY,
  kind {TEXT} NOT NULL CHECK (kind IN ('attempt', 'form', 'password')),
  id {TEXT} NOT NULL,
  since_us {INTEGER} NOT NULL,
  UNIQUE (kind, id)
) {STRICT};

-- The last number that outbox gave, which must not come again; the server this store belongs to, '' where to none.
CREATE TABLE site (
  one {INTEGER} NOT NULL PRIMARY KEY CHECK (one = 1),
  outbox_number {INTEGER} NOT NULL,
  server {TEXT} NOT NULL
) {STRICT};
INSERT INTO site VALUES (1, 0, '');

CREATE TABLE audit (
  number {INTEGER} NOT NULL PRIMARY KEY,
  time_us {INTEGER} NOT NULL,
  actor {TEXT} NOT NULL,
  workstation {TEXT} NOT NULL,
  act {TEXT} NOT NULL,
  person {TEXT} NOT NULL,
  detail {TEXT} NOT NULL,
  allowed {INTEGER} NOT NULL CHECK (allowed IN (0, 1)),
  hash {TEXT} NOT NULL CHECK (length(hash) = 64)
) {STRICT};
CREATE INDEX audit_by_actor ON audit (actor, number);
CREATE INDEX audit_by_person ON audit (person, number);

-- Where the log ends, so that a shorter one is seen.
CREATE TABLE audit_end (
  one {INTEGER} NOT NULL PRIMARY KEY CHECK (one = 1),
  number {INTEGER} NOT NULL,
  hash {TEXT} NOT NULL
) {STRICT};
INSERT INTO audit_end VALUES (1, 0, '');
