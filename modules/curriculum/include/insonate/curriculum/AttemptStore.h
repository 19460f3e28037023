#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/AttemptSeal.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// An attempt as stored in the database, with the data that the database adds.
struct StoredAttempt {
  AttemptFacts facts{};
  /// Number of the attempt in the database, from 1, in the order in which attempts were begun; independent of clocks.
  std::int64_t arrival = 0;
  /// true: the attempt was marked abandoned because the program crashed; the program may still report its real end
  bool crashed = false;
  std::string voidReason{};
  /// The database's copy of the recording; empty if there is none. The file has not been compared with
  /// facts.recordingHash.
  std::filesystem::path recordingFile{};

  bool operator==(const StoredAttempt&) const = default;
};

/// Access to the attempts in the database, with the permissions of a signed-in user. Attempts can be added and voided,
/// but neither changed nor deleted. Trainees see and make their own attempts. Instructors also see and void attempts of
/// learners in their cohorts (classes). Administrators see and void all attempts. Guests have no access.
class AttemptStore {
 public:
  explicit AttemptStore(SignedIn by) : by_(std::move(by)) {}

  /// Stores that an attempt has begun, with the members of `facts` up to `begun_us`. Returns the id of the attempt;
  /// generates one if `facts` has none. Person and workstation are those of the signed-in user. Storing the same facts
  /// again is no error. Fails if the attempt begins in the future or before its curriculum was published; clocks may
  /// differ by ten minutes.
  /// The database decides AttemptFacts::testConditions by its own clock and the openings that it knows. If the
  /// beginning is reported late because the database could not be reached, AttemptFacts::testConditions is decided when
  /// the attempt ends, by `facts.begun_us`, which a proven recording authenticates.
  Result<std::string> begin(const AttemptFacts& facts) const;
  /// Ends an attempt as Completed or Abandoned, with its metrics; values must be finite. Only the person who began the
  /// attempt may end it. Ending the attempt again with the same facts is no error; if an attempt was marked abandoned
  /// after a crash, its real end can be stored later. Fails if another stored attempt, of any person, has the same
  /// handsHash, since a recording counts only once. `facts.proof` is stored if the caller has determined that the proof
  /// is Proven or Demonstration; otherwise the attempt is stored as Unproven.
  Result<void> end(const AttemptFacts& facts) const;
  /// Stores a finished attempt: begin() and end() in one transaction. Returns the id. If `recording` (the file with
  /// hash facts.recordingHash) is given, the file is copied to the database's folder of recordings; if the copy fails,
  /// nothing is added. AttemptFacts::testConditions is decided by `facts.begun_us`; a demonstration counts as if the
  /// test had been open.
  Result<std::string> add(const AttemptFacts& facts, const std::filesystem::path& recording = {}) const;
  /// Copies the recording of an ended attempt to the database's folder of recordings. Only the person who made the
  /// attempt may call this function. Copying again is no error. If the database has no such folder, the function does
  /// nothing. Fails, with nothing changed, if the file does not have the attempt's recordingHash, or if it cannot be
  /// copied.
  Result<void> storeRecording(const std::string& attempt, const std::filesystem::path& recording) const;
  /// Issues nonce and key for the recording of a new attempt of the signed-in user. Nonce and key depend on the
  /// attempt's id, curriculum and level.
  Result<AttemptSeal> issueSeal(const AttemptFacts& facts) const;
  /// Tells whether this database issued `nonce` to the attempt with the id, person, curriculum and level of `facts`.
  Result<NonceOrigin> originOf(const AttemptFacts& facts, const std::string& nonce) const;
  /// Accepts an ended attempt without proof of origin, so that it counts. The audit log stores the signed-in user's
  /// name and reason. Allowed to instructors and administrators, not for their own attempts. Accepting again is no
  /// error.
  Result<void> accept(const std::string& attempt, const std::string& reason) const;
  /// Excludes an ended attempt from all counts. Allowed to instructors and administrators, not for their own attempts.
  Result<void> voidAttempt(const std::string& attempt, const std::string& reason) const;

  Result<StoredAttempt> attempt(const std::string& id) const;
  /// Returns attempts of a person, newest first: at most `count` (1 to 1000) attempts whose StoredAttempt::arrival is
  /// below `before`. `before` 0: no limit.
  Result<std::vector<StoredAttempt>> page(const std::string& person, int count, std::int64_t before = 0) const;
  /// Returns all attempts of a person in the order in which they were begun, for unlocking levels and for statistics;
  /// caseHash, workstation, recording, recordingHash and handsHash stay empty.
  Result<std::vector<AttemptFacts>> history(const std::string& person) const;
  /// Returns, for each learner in a cohort, the last `count` (1 to 1000) attempts that count (Judgement.h), without
  /// free practice; grouped by person, each group in the order of history().
  Result<std::vector<AttemptFacts>> recentOfCohort(const std::string& cohort, int count) const;

  /// Returns the id of the attempt whose recording has this hash; if there is none, the id of an attempt on this
  /// workstation whose recording has this file name; else "". The other facts can be read with attempt(), which checks
  /// permissions.
  Result<std::string> findByRecording(const std::string& name, const std::string& hash) const;

  /// Returns Member::changes of a person: a counter of changes to the person's attempts. Read it before the history
  /// from which a Standing is computed.
  Result<std::int64_t> changes(const std::string& person) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
