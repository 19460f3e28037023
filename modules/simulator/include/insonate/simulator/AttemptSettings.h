#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/PressedTissue.h>

#include <optional>
#include <string>
#include <string_view>

namespace insonate {

/// All that, with a case and what the hands did, decides the images of an attempt: what AttemptHeader::settings and
/// SettingsChange keep.
struct AttemptSettings {
  /// Setup with the engine that made the images, not "auto". Replays ignore persistence.
  ImagingSetup setup;
  Physiology physiology;
  bool pulsating = false;  ///< false: blood is at its mean pressure
  double bloodTime_s = 0;  ///< of heart and breath when the recording began
  std::string needle;      ///< preset of NeedleTable, or the name of a file
  double needleRadius_mm = 0.635, needleLength_mm = 70;

  /// Blood pressure at a time of the recording.
  BloodPressure blood(double time_s) const {
    return bloodPressure(physiology, setup.mechanics.tissues,
                         pulsating ? std::optional(bloodTime_s + time_s) : std::nullopt);
  }
};

/// Settings as JSON, with all numbers to the last bit.
std::string textOf(const AttemptSettings& settings);
/// Fails with a sentence on an invalid text, and on values out of range.
Result<AttemptSettings> parseAttemptSettings(std::string_view json);

}  // namespace insonate
