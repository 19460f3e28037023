#pragma once

#include "Anatomy.h"
#include "BodySurface.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

namespace insonate::phantom {

/// Mathematical model of a whole neck: depth and structure at each patient position, from which label maps are sampled.
/// The object is immutable.
class NeckModel {
 public:
  NeckModel(const NeckParameters& parameters, std::uint32_t seed);

  /// Returns the labels at the voxel centers of a grid whose axes are the patient's axes. Returns identical bytes on
  /// any number of threads.
  Result<LabelMap> rasterise(const VolumeGeometry& geometry, const Progress& progress) const;

  /// Returns the depth below the skin's surface at a patient position (negative outside), mm, to first order.
  double belowSkin_mm(Vec3 patient_mm) const;
  /// Returns the center of an internal jugular vein at a level, patient mm.
  Vec3 jugularCenter_mm(Side side, double z_mm) const;
  /// Returns the center of an axillary vein at a distance from the midline, patient mm.
  Vec3 axillaryCenter_mm(Side side, double lateral_mm) const;
  Vec3 patientFromModel(Vec3 model_mm) const;
  /// Returns all named vessels, patient mm.
  std::vector<NamedVessel> namedVessels() const;

 private:
  Vec3 modelFromPatient(Vec3 patient_mm) const;
  /// Returns the rotation of the head at a level, radians.
  double twist(double z_mm) const;

  NeckParameters parameters_;
  std::uint32_t seed_;
  BodySurface surface_;
  std::vector<Structure> structures_;
};

}  // namespace insonate::phantom
