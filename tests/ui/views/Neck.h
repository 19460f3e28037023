#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/Imager.h>
#include <insonate/views/VtkCase.h>

#include <memory>

namespace insonate::test {

/// The built-in neck, the linear probe at its first start pose, and what that shows: made once a process.
struct Neck {
  std::shared_ptr<const PatientCase> patient;
  std::shared_ptr<const views::VtkCase> shown;
  ImagingSetup setup;
  Transform patientFromProbe;
  BModeImage image;
};

const Neck& neck();

/// A box of air with one bright, labeled voxel, to see where things appear.
std::shared_ptr<PatientCase> oneVoxel(const VolumeGeometry& grid, int i, int j, int k);

}  // namespace insonate::test
