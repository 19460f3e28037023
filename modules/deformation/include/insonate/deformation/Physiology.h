#pragma once

#include <insonate/core/Result.h>
#include <insonate/deformation/DeformationModel.h>

namespace insonate {

inline constexpr double kPascalPermmHg = 133.322;

/// Properties of circulation, respiration and body position that determine the blood pressure at the site of the probe.
/// Pressures are in mmHg above atmospheric. The defaults describe a healthy adult at rest, supine; the resulting mean
/// pressures equal the pressures in the CT (MechanicalTissue::pressure_kPa) of the preset `measured`. Sources:
/// modules/deformation/README.md.
struct Physiology {
  double centralVenous_mmHg = 4;  ///< venous pressure at the heart, mean over a breath; -5 to 30
  double systolic_mmHg = 120;    ///< maximum arterial pressure of a heartbeat, at the heart; 40 to 260, above diastolic
  double diastolic_mmHg = 80;    ///< minimum arterial pressure of a heartbeat, at the heart; 20 to 180
  double heartRate_perMin = 70;  ///< heart rate, 20 to 250; 0 for no pulse (constant mean pressure)
  double breathing_perMin = 14;  ///< respiratory rate, 2 to 60; 0 for no respiration
  /// Peak-to-peak change of the venous pressure in the neck by respiration, -20 to 20. Positive: the minimum is at the
  /// end of inspiration; negative: at the end of expiration, as under mechanical ventilation. Below the diaphragm the
  /// change is smaller, and inspiration always raises the pressure, since it raises that of the abdomen.
  double breathingSwing_mmHg = 2.5;
  double tilt_deg = 0;  ///< tilt of the table, -45 to 45; positive: head down (Trendelenburg)
  /// Distance along the body from the heart to the site of the probe, positive toward the head, -600 to 300. A site
  /// more than 100 mm toward the feet is below the diaphragm.
  double siteAboveHeart_mm = 150;
  double indifferenceFromHeart_mm = 70;  ///< distance from the heart, toward the feet, of the point whose venous
                                         ///< pressure does not change with tilt; 0 to 200
  /// Peak-to-peak distance by which the lung slides along the pleura with respiration, 0 to 30; 0: the lung does not
  /// slide, as with a pneumothorax.
  double lungSlide_mm = 6;

  bool operator==(const Physiology&) const = default;
};

/// Fails with a sentence that names field, value and allowed range.
Result<void> checkPhysiology(const Physiology& physiology);

/// Returns the phase of the heartbeat at a time in s, 0 to 1; 0: the arterial pressure begins to rise. 0 if the heart
/// rate is 0. A time that is not finite counts as 0.
double heartPhaseAt(const Physiology& physiology, double time_s);
/// Returns the state of respiration at a time in s, from 0.5 (end of expiration) to -0.5 (end of inspiration); 0
/// without respiration.
double respirationAt(const Physiology& physiology, double time_s);
/// Returns the distance by which the lung has slid toward the head at a time in s, mm: positive in expiration, and 0 on
/// average over the extremes.
double lungSlideAt_mm(const Physiology& physiology, double time_s);

/// Returns the blood pressures at the site at a time in s. The pressures are continuous and periodic with heartbeat and
/// respiration. vein_kPa is never below 0, since a vein collapses near atmospheric pressure. The physiology must be
/// valid; a time that is not finite counts as 0.
BloodPressure bloodPressureAt(const Physiology& physiology, double time_s);

/// Returns the pressure in an open vein at the site, in mmHg above the pressure of the room. Unlike
/// BloodPressure::vein_kPa it can be negative above the diaphragm: air then enters through an open needle.
double venousPressure_mmHg(const Physiology& physiology, double time_s);

/// Returns the blood pressures at the site, averaged over heartbeats and breaths.
BloodPressure meanBloodPressure(const Physiology& physiology);

}  // namespace insonate
