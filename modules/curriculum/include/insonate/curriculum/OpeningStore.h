#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Data of a new opening: a period during which attempts at a test count. An opening has an end, a code, or both.
struct NewOpening {
  std::string cohort{};                    ///< class for which the test is opened (Cohort::id); "": everyone
  std::string curriculum{};                ///< name of the curriculum; used only if `cohort` is empty
  std::string level{};                     ///< Level::name of a test
  std::optional<std::int64_t> start_us{};  ///< start, since 1970, UTC; empty or in the past: now
  std::optional<std::int64_t> end_us{};    ///< end, since 1970, UTC; empty: the test stays open until it is closed
  std::string code{};                      ///< code of 4 to 32 characters that trainees enter; "": none
};

/// A period during which attempts at a test count, for all versions of the curriculum.
struct TestOpening {
  std::string id{};      ///< UUID
  std::string cohort{};  ///< class (Cohort::id); "": everyone
  std::string curriculum{}, level{};
  std::int64_t start_us = 0;
  std::optional<std::int64_t> end_us{};
  bool hasCode = false;
  std::string openedBy{};  ///< full name of the person who opened the test, or sign-in name if there is no full name
  std::int64_t opened_us = 0;
  std::optional<std::int64_t> closed_us{};  ///< time at which the opening was closed before its end
  std::string closedBy{};

  bool operator==(const TestOpening&) const = default;
};

/// State of an opening at a time.
enum class OpeningState {
  Waiting,  ///< the period of the opening has not begun yet
  Open,
  Ended,   ///< after the end of the opening
  Closed,  ///< closed before the end of the opening
};
OpeningState stateAt(const TestOpening& opening, std::int64_t now_us);
/// Returns "waiting", "open", "ended" or "closed".
const char* nameOf(OpeningState state);

/// Answer to the question whether an attempt of the signed-in user at a test would count now.
struct TestAdmission {
  enum class Kind {
    Open,
    SelfAdministered,  ///< the attempt would count: the user has no class with another member, so that no instructor
                       ///< opens tests
    NeedsCode,         ///< the attempt would count after the user has entered the code
    Closed,            ///< no test is open for the user: the attempt would be practice
  };
  Kind kind = Kind::Closed;
  std::optional<std::int64_t> end_us{};   ///< if Open: the latest end of the openings; empty: the test stays open
                                          ///< until it is closed
  std::optional<std::int64_t> next_us{};  ///< if Closed: start of the next opening

  bool operator==(const TestAdmission&) const = default;
};

/// Access to the openings of tests in the database, with the permissions of a signed-in user. Instructors open tests
/// for their cohorts (classes), administrators for all cohorts and for everyone. If the workstation belongs to a
/// server, tests can be opened on the server only. AttemptStore decides whether an attempt counts
/// (AttemptFacts::testConditions).
class OpeningStore {
 public:
  explicit OpeningStore(SignedIn by) : by_(std::move(by)) {}

  /// Opens a test. Fails if the level is no test of the cohort's curriculum (for everyone: of the newest published
  /// version).
  Result<TestOpening> open(const NewOpening& opening) const;
  /// Closes an opening of a cohort ("": everyone) now; attempts in progress still count. Closing an opening that has
  /// ended is no error.
  Result<void> close(const std::string& cohort, const std::string& opening) const;
  /// Returns the openings of a cohort and those for everyone, newest first.
  Result<std::vector<TestOpening>> listByCohort(const std::string& cohort) const;
  /// Returns all openings, newest first. For administrators.
  Result<std::vector<TestOpening>> all() const;

  /// Tells whether an attempt of the signed-in user at a test would count now.
  Result<TestAdmission> admission(const std::string& curriculum, const std::string& level) const;
  /// Enters the code of a test. Fails if the code is wrong. After five wrong codes, further codes are refused for 30 s;
  /// this time doubles with each further wrong code, up to an hour. Case is ignored. Takes about 0.1 s.
  Result<TestAdmission> enterCode(const std::string& curriculum, const std::string& level,
                                  const std::string& code) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
