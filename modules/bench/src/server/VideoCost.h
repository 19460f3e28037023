#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <filesystem>

namespace insonate::bench {

/// Cost of the video of one attempt.
struct VideoCost {
  double attempt_s = 0;    ///< duration of the attempt
  double processor_s = 0;  ///< processor time to make the video, of all threads
  double size_MB = 0;
};

/// Makes the video of the demonstration attempt, as the server does. Takes about half a minute on two cores; the
/// processor time of other threads of the program counts as well. Writes temporary files into `folder`.
Result<VideoCost> measureVideoCost(const std::filesystem::path& folder, const Progress& progress);

}  // namespace insonate::bench
