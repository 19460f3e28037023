#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/VerificationQueue.h>

#include <string>

namespace insonate {

/// Returns why the facts of an attempt, which a workstation has sent, do not follow from the attempt's recording: the
/// recording was changed, belongs to another attempt, person or level, was made on another case than that of the level,
/// or gives other metrics or points. Returns "" if the facts follow from the recording. `cases`: folder with the
/// folders of the server's cases; attempts on these cases count only if their version was published. May be empty. The
/// recording is replayed without images, in a tenth of a second. Fails if the recording, the database or the folder of
/// cases cannot be read.
Result<std::string> whyNotVerified(const VerificationQueue& queue, const WaitingAttempt& attempt,
                                   const std::filesystem::path& cases = {});

/// Verifies the next attempt that waits. Returns false if none waits. Fails if the recording, the database or the
/// folder of cases cannot be read; the attempt then continues to wait.
Result<bool> verifyNextAttempt(const VerificationQueue& queue, const std::filesystem::path& cases = {});

}  // namespace insonate
