#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/PressedTissue.h>

#include <optional>
#include <string>
#include <string_view>

namespace insonate {

/// Everything that decides the images of an attempt, apart from the case and the motion of the hands.
/// AttemptHeader::settings and SettingsChange store it.
struct AttemptSettings {
  /// Setup with the engine that made the images, not "auto". Replays ignore persistence.
  ImagingSetup setup;
  Physiology physiology;
  bool pulsating = false;  ///< false: blood is at its mean pressure
  double bloodTime_s = 0;  ///< time of heartbeat and breathing when the recording began
  std::string needle;      ///< preset of NeedleTable, or the name of a file
  double needleRadius_mm = 0.635, needleLength_mm = 70;

  /// Blood pressure at a time of the recording.
  BloodPressure blood(double time_s) const {
    return bloodPressure(physiology, setup.mechanics.tissues,
                         pulsating ? std::optional(bloodTime_s + time_s) : std::nullopt);
  }
};

/// Writes settings as JSON that reads back to exactly the same numbers.
std::string textOf(const AttemptSettings& settings);
/// Reads settings. Fails with a sentence on an invalid text or on values out of range.
Result<AttemptSettings> parseAttemptSettings(std::string_view json);

}  // namespace insonate
