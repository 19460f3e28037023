#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/VerificationQueue.h>
#include <insonate/teaching/RecomputedAttempts.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Returns why the facts of an attempt, which a workstation has sent, do not follow from the attempt's recording: the
/// recording was changed, belongs to another attempt, person or level, was made on another case than that of the level,
/// or gives other metrics, points
/// or needle events. Returns "" if the facts follow from the recording. `cases`: folder with the
/// folders of the server's cases; attempts on these cases count only if their version was published. May be empty.
/// `events`: compares needle events with the motion; empty: the recorded events are taken as they are, as they are on a
/// case that the server does not have. The recording is replayed without images, in a tenth of a second without
/// `events` and some seconds with them. Fails if the recording, the database or the folder of cases cannot be read.
Result<std::string> whyNotVerified(const VerificationQueue& queue, const WaitingAttempt& attempt,
                                   const std::filesystem::path& cases = {}, const CompareEvents& events = {});

/// Verifies the next attempt that waits. Returns false if none waits. Fails if the recording, the database or the
/// folder of cases cannot be read, or if `events` was cancelled; the attempt then continues to wait.
Result<bool> verifyNextAttempt(const VerificationQueue& queue, const std::filesystem::path& cases = {},
                               const CompareEvents& events = {});

}  // namespace insonate
