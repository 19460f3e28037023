#pragma once

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/SignedIn.h>

#include <optional>
#include <string>
#include <vector>

namespace insonate::review {

/// Attempt and trainee of a recording according to the store.
struct RecordingOrigin {
  std::optional<AttemptFacts> attempt{};  ///< empty if the store has no attempt with this recording
  Person person{};                        ///< trainee of the attempt
  bool same = false;                      ///< the file's SHA-256 is that of the attempt's recording
  std::vector<KeptForm> forms{};          ///< forms about the attempt, in the order of submission
};

/// Finds a recording's origin. `expected` is the id of the attempt that the user selected; if it is "", the attempt is
/// looked up. Fails if the user may not see the attempt. For the account's thread.
Result<RecordingOrigin> readOrigin(const SignedIn& by, const std::string& file, const std::string& expected);

}  // namespace insonate::review
