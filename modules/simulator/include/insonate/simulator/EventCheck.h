#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/procedure/EventDifference.h>

#include <filesystem>
#include <memory>
#include <vector>

namespace insonate {

/// Checks the needle events of recordings: moves a needle through the attempt's case as it was recorded, and compares
/// the walls that this needle punctures with the recorded events.
///
/// The tissue is deformed by the recorded pose of the probe at its mean blood pressure. Live imaging solves the same
/// deformation with fewer iterations and some milliseconds later, and forces of a device limit the stiffness of walls.
/// An event therefore counts as different only if the tip was clearly elsewhere: more than 2 mm outside the wall that
/// it is said to have punctured, or more than 2 mm inside a structure without a recorded puncture. Events of wire,
/// dilator, catheter and image are not checked.
///
/// One object must not be used concurrently; uses the calling thread's TBB arena.
class EventCheck {
 public:
  /// `libraries`: folders of case folders; empty: only the built-in cases are known.
  explicit EventCheck(std::vector<std::filesystem::path> libraries);
  EventCheck(EventCheck&&) noexcept;
  EventCheck& operator=(EventCheck&&) noexcept;
  ~EventCheck();

  /// Returns the differences, in the order of their times; at most 20. Takes from tenths of a second to
  /// about ten seconds, depending on how much the probe moves while the needle is in the body, and some seconds more
  /// for the first recording on a case. Fails if the case cannot be found
  /// (see caseOfAttempt()), if the recording is damaged or without settings, or if cancelled.
  Result<std::vector<EventDifference>> compare(const AttemptRecording& recording, const Progress& progress = {});

 private:
  struct Case;
  Result<void> take(const AttemptHeader& header, const Progress& progress);

  std::vector<std::filesystem::path> libraries_;
  std::unique_ptr<Case> case_;  ///< the case of the last recording
};

}  // namespace insonate
