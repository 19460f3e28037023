#pragma once

#include "BodySurface.h"
#include "Structure.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <functional>

namespace insonate::phantom {

/// Parts of the model of a region of the body.
struct RegionParts {
  LayerOptions layers;
  Platysma platysma;
  std::vector<Structure> structures;  ///< in order of precedence
  std::vector<VesselCourse> vessels;
  std::uint32_t seed = 1;
  std::function<double(double z_mm)> twist{};  ///< rotation about the spine by level, radians; empty: none
};

/// Mathematical model of a region of the body: depth and structure at each patient position, from which label maps are
/// sampled. The object is immutable.
class RegionModel {
 public:
  explicit RegionModel(RegionParts parts);

  /// Returns the labels at the voxel centers of a grid whose axes are the patient's axes. Returns identical bytes on
  /// any number of threads.
  Result<LabelMap> rasterise(const VolumeGeometry& geometry, const Progress& progress) const;

  /// Returns the depth below the skin's surface at a patient position (negative outside), mm, to first order.
  double belowSkin_mm(Vec3 patient_mm) const;
  Vec3 patientFromModel(Vec3 model_mm) const;
  /// Returns all named vessels, patient mm.
  std::vector<NamedVessel> namedVessels() const;

 private:
  Vec3 modelFromPatient(Vec3 patient_mm) const;
  double twist(double z_mm) const { return parts_.twist ? parts_.twist(z_mm) : 0; }

  RegionParts parts_;
  BodySurface surface_;
};

}  // namespace insonate::phantom
