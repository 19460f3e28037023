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

/// An attempt with the data that the store adds to it.
struct KeptAttempt {
  AttemptFacts facts{};
  /// Number of attempts begun in the store up to this one; orders attempts independently of clocks.
  std::int64_t arrival = 0;
  bool crashed = false;  ///< marked abandoned since its process died; the real end may still arrive
  std::string voidReason{};
  /// File of the recording in the store; empty if the store keeps none. The file is not compared with
  /// facts.recordingHash.
  std::filesystem::path recordingFile{};

  bool operator==(const KeptAttempt&) const = default;
};

/// Stores attempts: their facts are begun, ended and possibly voided, but neither changed nor deleted. Trainees see and
/// make their own attempts; instructors also see and void those of learners in their cohorts; administrators see and
/// void all. Guests have no access.
class AttemptStore {
 public:
  explicit AttemptStore(SignedIn by) : by_(std::move(by)) {}

  /// Stores that an attempt has begun, with the members of `facts` up to `begun_us`. Person and workstation are taken
  /// from the session; a missing id is made. Returns the id. Storing the same facts again is no error. Fails if the
  /// attempt begins in the future or before its curriculum was published; clocks may differ by ten minutes.
  Result<std::string> begin(const AttemptFacts& facts) const;
  /// Ends an attempt as Completed or Abandoned, with its metrics; values must be finite. Only the person who began it
  /// may end it. Ending it again with the same facts is no error, and an attempt that was marked abandoned after a
  /// crash accepts its real end later. Fails if another attempt of the store, of any person, has the same handsHash: a
  /// recording counts once. `facts.proof` is stored if it is Proven or Demonstration, as determined by the caller;
  /// otherwise the attempt is unproven.
  Result<void> end(const AttemptFacts& facts) const;
  /// Stores a finished attempt: begin() and end() in one transaction. Returns the id. With `recording`, the file of
  /// facts.recordingHash is copied to the store's recordings; if that fails, nothing is added.
  Result<std::string> add(const AttemptFacts& facts, const std::filesystem::path& recording = {}) const;
  /// Copies the recording of an ended attempt to the store's recordings. Only the person who made the attempt may call
  /// this. Copying again is no error; a store that keeps no recordings does nothing. Fails, with nothing changed, if
  /// the file does not have the attempt's recordingHash, or if it cannot be copied.
  Result<void> keepRecording(const std::string& attempt, const std::filesystem::path& recording) const;
  /// Issues the seal for the recording of a new attempt: for its id, curriculum and level, and for the signed-in user.
  Result<AttemptSeal> seal(const AttemptFacts& facts) const;
  /// Tells whether this store issued the nonce to an attempt with this id, person, curriculum and level.
  Result<NonceOrigin> originOf(const AttemptFacts& facts, const std::string& nonce) const;
  /// Accepts an unproven, ended attempt, so that it counts. The audit log stores the signed-in user's name and reason.
  /// For instructors and administrators, not for their own attempts. Accepting again is no error.
  Result<void> accept(const std::string& attempt, const std::string& reason) const;
  /// Excludes an ended attempt from the count; for instructors and administrators, not for their own attempts.
  Result<void> voidAttempt(const std::string& attempt, const std::string& reason) const;

  Result<KeptAttempt> attempt(const std::string& id) const;
  /// Returns the newest attempts of a person first: at most `count` (1..1000) of those that arrived before `before`; 0:
  /// the newest of all.
  Result<std::vector<KeptAttempt>> page(const std::string& person, int count, std::int64_t before = 0) const;
  /// Returns all attempts of a person in the order of arrival, for unlocking and statistics, without caseHash,
  /// workstation, recording, recordingHash and handsHash.
  Result<std::vector<AttemptFacts>> history(const std::string& person) const;
  /// Returns the last `count` attempts (1..1000) at levels that count (Judgement.h) of each learner in a cohort,
  /// without free practice; grouped by person, each in the order of arrival, like history().
  Result<std::vector<AttemptFacts>> lastOfCohort(const std::string& cohort, int count) const;

  /// Returns the id of the attempt whose recording has this hash. If there is none, returns the id of an attempt made
  /// on this workstation whose recording has this name; otherwise "". All other facts come from attempt(), which checks
  /// permissions.
  Result<std::string> ofRecording(const std::string& name, const std::string& hash) const;

  /// Returns Member::changes of a person. Call it before reading the history from which a Standing is computed.
  Result<std::int64_t> changes(const std::string& person) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
