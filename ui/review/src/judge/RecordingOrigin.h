#pragma once

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/SignedIn.h>

#include <optional>
#include <string>
#include <vector>

namespace insonate::review {

/// Attempt and trainee of a recording, by the store.
struct RecordingOrigin {
  std::optional<AttemptFacts> attempt{};  ///< none: of none that is kept
  Person person{};                        ///< whose it is
  bool same = false;                      ///< the file is the one that was recorded, by its SHA-256
  std::vector<KeptForm> forms{};          ///< about the attempt, in the order in which they came
};

/// `expected` is the attempt that the recording was chosen as; "": it is looked for. Fails where who asks may not see
/// the attempt. For the account's thread.
Result<RecordingOrigin> readOrigin(const SignedIn& by, const std::string& file, const std::string& expected);

}  // namespace insonate::review
