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

/// An attempt with what the store adds to it.
struct KeptAttempt {
  AttemptFacts facts{};
  std::int64_t arrival = 0;  ///< the store's count of attempts begun; orders attempts where clocks cannot
  bool crashed = false;      ///< told abandoned since its process died; its real end may still come
  std::string voidReason{};
  /// Its recording as the store keeps it; "": it keeps none. Whether it is the one of facts.recordingHash is not looked
  /// at.
  std::filesystem::path recordingFile{};

  bool operator==(const KeptAttempt&) const = default;
};

/// Attempts: facts that are begun, ended and perhaps voided, and neither changed nor deleted. Trainees see and make
/// their own, instructors also see and void those of who learns in their cohorts, administrators all. A guest's are
/// refused.
class AttemptStore {
 public:
  explicit AttemptStore(SignedIn by) : by_(std::move(by)) {}

  /// Writes down that one has begun: of facts up to `begun_us`; person and workstation are those of the session, a
  /// missing id is made. Gives the id. The same facts once more are no error. Refused where it begins in the future, or
  /// before its curriculum was published; clocks may differ by ten minutes.
  Result<std::string> begin(const AttemptFacts& facts) const;
  /// Completed or Abandoned, with what was measured; values must be finite. The same facts once more are no error, and
  /// an attempt that was told abandoned after a crash takes its real end later. By who began it. Refused where another
  /// attempt of the store, of whomever, has the same handsHash: a recording counts once. `facts.proof` is kept where it
  /// is Proven or Demonstration, as the caller found it; otherwise nothing vouches for the attempt.
  Result<void> end(const AttemptFacts& facts) const;
  /// begin() and end() of an attempt that is over, or neither. Gives the id. With `recording`, the file of
  /// facts.recordingHash is copied to the store's recordings; where that fails, nothing is added.
  Result<std::string> add(const AttemptFacts& facts, const std::filesystem::path& recording = {}) const;
  /// Copies the recording of an attempt that has ended to the store's recordings; by who made it. Again is no error,
  /// and neither is a store that keeps none. Fails, with nothing changed, where the file is not the one of the
  /// attempt's recordingHash, and where it cannot be copied.
  Result<void> keepRecording(const std::string& attempt, const std::filesystem::path& recording) const;
  /// For the recording of an attempt that begins: of its id, curriculum and level, and of who is signed in.
  Result<AttemptSeal> seal(const AttemptFacts& facts) const;
  /// Tells whether this store issued the nonce to an attempt with this id, person, curriculum and level.
  Result<NonceOrigin> originOf(const AttemptFacts& facts, const std::string& nonce) const;
  /// Counts an ended attempt that nothing proves, on the word of who is signed in, whose name and reason are in the
  /// audit log; instructors and administrators, not for their own. Accepted once more is no error.
  Result<void> accept(const std::string& attempt, const std::string& reason) const;
  /// Takes an ended attempt out of the count; instructors and administrators, not for their own.
  Result<void> voidAttempt(const std::string& attempt, const std::string& reason) const;

  Result<KeptAttempt> attempt(const std::string& id) const;
  /// Newest first, at most `count` (1..1000) that came before `before`; 0: the newest.
  Result<std::vector<KeptAttempt>> page(const std::string& person, int count, std::int64_t before = 0) const;
  /// All of a person in the order of arrival, for unlocking and statistics. Without caseHash, workstation, recording,
  /// recordingHash and handsHash, which those do not need.
  Result<std::vector<AttemptFacts>> history(const std::string& person) const;
  /// The last `count` attempts (1..1000) at levels that count (Judgement.h) of each who learns in a cohort, without
  /// free practice; grouped by person, each in the order of arrival, as history() gives them.
  Result<std::vector<AttemptFacts>> lastOfCohort(const std::string& cohort, int count) const;

  /// The id of the attempt of whose recording this is the hash; else of one made on this workstation whose recording
  /// has this name; else "". It tells nothing else: what the attempt is, attempt() tells to whom it may.
  Result<std::string> ofRecording(const std::string& name, const std::string& hash) const;

  /// Member::changes of a person, to be asked before the history that a Standing is worked out from.
  Result<std::int64_t> changes(const std::string& person) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
