#pragma once

#include <insonate/core/Result.h>
#include <insonate/deformation/DeformationModel.h>

namespace insonate {

inline constexpr double kPascalPermmHg = 133.322;

/// Heart, respiration and gravity, which determine the blood pressure in the neck. Pressures are in mmHg above
/// atmospheric, the clinical unit. The defaults are a healthy adult at rest, supine; their means are the pressures at
/// which a CT was taken according to the preset `measured` of MechanicalTable. Sources: modules/deformation/README.md.
struct Physiology {
  double centralVenous_mmHg = 4;  ///< venous pressure at the heart, mean over a breath; -5..30
  double systolic_mmHg = 120;     ///< maximum arterial pressure of a heartbeat, at the heart; 40..260, above diastolic
  double diastolic_mmHg = 80;     ///< minimum arterial pressure of a heartbeat, at the heart; 20..180
  double heartRate_perMin = 70;   ///< heart rate, 20..250; 0 for no pulse (constant mean pressure)
  double breathing_perMin = 14;   ///< respiratory rate, 2..60; 0 for no respiration
  /// Peak-to-peak change of the neck's venous pressure; 0..20 for a minimum at the end of inspiration. Negative, down
  /// to -20, for a minimum at the end of expiration, as under mechanical ventilation.
  double breathingSwing_mmHg = 2.5;
  double tilt_deg = 0;                   ///< tilt of the table, -45..45; above 0 head down (Trendelenburg)
  double neckAboveHeart_mm = 150;        ///< distance along the body from the heart to the probe; 50..300
  double indifferenceFromHeart_mm = 70;  ///< distance from the heart, toward the feet, of the point whose venous
                                         ///< pressure does not change with tilt; 0..200
};

/// Fails with a sentence that names field, value and allowed range.
Result<void> checkPhysiology(const Physiology& physiology);

/// Returns the pressures in the neck at a time in s, continuous and periodic with heartbeat and respiration. A vein
/// whose pressure would be below atmospheric has collapsed and stays near atmospheric pressure: vein_kPa is never below
/// 0. The physiology must be valid; a time that is not finite counts as 0.
BloodPressure bloodPressureAt(const Physiology& physiology, double time_s);

/// Returns the pressures of vein and artery, averaged over heartbeats and breaths.
BloodPressure meanBloodPressure(const Physiology& physiology);

}  // namespace insonate
