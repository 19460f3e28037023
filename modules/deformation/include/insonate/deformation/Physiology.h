#pragma once

#include <insonate/core/Result.h>
#include <insonate/deformation/DeformationModel.h>

namespace insonate {

inline constexpr double kPascalPermmHg = 133.322;

/// Pressures that act on the blood of the neck: heart, breath and gravity, in mmHg above atmospheric, as clinicians
/// state them. The defaults are a healthy adult at rest, lying flat; their means are the pressures at which the preset
/// `measured` of MechanicalTable assumes a CT was taken. Sources: modules/deformation/README.md.
struct Physiology {
  double centralVenous_mmHg = 4;  ///< at the heart, mean over a breath; -5..30
  double systolic_mmHg = 120;     ///< at the heart; 40..260, above diastolic
  double diastolic_mmHg = 80;     ///< 20..180
  double heartRate_perMin = 70;   ///< 20..250; 0: no pulse, mean pressure all the time
  double breathing_perMin = 14;   ///< 2..60; 0: no breath
  /// Peak to peak, in the veins of the neck, low at the end of breathing in; 0..20. Negative to -20: low at the end of
  /// breathing out, as a ventilator does it.
  double breathingSwing_mmHg = 2.5;
  double tilt_deg = 0;                   ///< of the table; above 0 head down (Trendelenburg), -45..45
  double neckAboveHeart_mm = 150;        ///< along the body, from the heart to the probe; 50..300
  double indifferenceFromHeart_mm = 70;  ///< from the heart down to where tilting leaves venous pressure alone; 0..200
};

/// Fails with a sentence that names field, value and allowed range.
Result<void> checkPhysiology(const Physiology& physiology);

/// Pressures in the neck at a time, s; periodic with heart and breath, continuous. A vein that would be under less than
/// the air's pressure has collapsed and stays near it: vein_kPa is never below 0. The physiology must be valid; a time
/// that is not finite counts as 0.
BloodPressure bloodPressureAt(const Physiology& physiology, double time_s);

/// Mean pressures of the vein and the artery over heart beats and breaths.
BloodPressure meanBloodPressure(const Physiology& physiology);

}  // namespace insonate
