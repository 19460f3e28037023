#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/CompressedTissue.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/Pneumothorax.h>
#include <insonate/simulator/SalineFlush.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Settings that determine the images of an attempt, together with the case and the motion of probe and needle.
/// AttemptHeader::settings and SettingsChange store them.
struct AttemptSettings {
  /// Probe, imaging settings, tissues and mechanics. ImagingSetup::engine is the engine that made the images, never
  /// "auto". Replays ignore persistence.
  ImagingSetup setup;
  Physiology physiology;
  bool pulsating = false;  ///< true: heartbeat and breathing vary the blood pressure; false: the pressure stays at its
                           ///< mean
  double bloodTime_s = 0;  ///< time in the cycles of heartbeat and breathing at which the recording began
  std::string needle;      ///< name of a NeedleTable preset, or file name of a needle table
  double needleRadius_mm = 0.635, needleLength_mm = 70;
  std::vector<FlexibleRod> rods{};     ///< wire, dilator and catheter in the body
  std::optional<SalineFlush> flush{};  ///< last flush whose bubbles the images show; empty: none
  Pneumothorax pneumothorax{};         ///< times since the recording began

  /// Returns the blood pressure at a time since the recording began.
  BloodPressure blood(double time_s) const {
    return bloodPressure(physiology, setup.mechanics.tissues,
                         pulsating ? std::optional(bloodTime_s + time_s) : std::nullopt);
  }
  /// Returns the motion of the lungs at a time since the recording began.
  LungMotion lung(double time_s) const {
    return {pulsating ? lungSlideAt_mm(physiology, bloodTime_s + time_s) : 0, pneumothorax.detachedAt_mm(time_s)};
  }
};

/// Writes settings as JSON, from which parseAttemptSettings() reads exactly the same numbers.
std::string textOf(const AttemptSettings& settings);
/// Reads settings. Fails with a sentence on an invalid text or on values out of range.
Result<AttemptSettings> parseAttemptSettings(std::string_view json);

}  // namespace insonate
