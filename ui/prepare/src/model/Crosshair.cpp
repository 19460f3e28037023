#include "Crosshair.h"

#include "LivePatient.h"
#include "Notice.h"
#include "OpenCase.h"

#include <algorithm>

namespace insonate::prepare {
namespace {

/// Center of the middle voxel: between two voxels, slices would blend both, and labels would be those of one side.
Vec3 middleOf(const VolumeGeometry& grid) {
  const auto [i, j, k] = nearestVoxel(grid.indexFromPatient() * grid.center_mm());
  return grid.patientFromIndex() * Vec3{double(i), double(j), double(k)};
}

}  // namespace

Crosshair::Crosshair(OpenCase& openCase, LivePatient& live, Notice& notice, QObject* parent)
    : QObject(parent), openCase_(openCase), live_(live), notice_(notice) {
  connect(&openCase_, &OpenCase::opened, this,
          [this] { position_mm_ = openCase_.patient() ? middleOf(openCase_.patient()->ct.geometry) : Vec3{}; });
  connect(&live_, &LivePatient::started, this, [this] {
    // The view starts at the case's start pose, unless the author has already moved it.
    if (position_mm_ != middleOf(openCase_.patient()->ct.geometry)) return;
    position_mm_ = live_.start()->position_mm;
    Q_EMIT moved();
  });
}

void Crosshair::moveTo(Vec3 patient_mm) {
  if (!openCase_.patient() || !isFinite(patient_mm)) return;
  const VolumeGeometry& grid = openCase_.patient()->ct.geometry;
  Vec3 index = grid.indexFromPatient() * patient_mm;
  for (int axis = 0; axis < 3; ++axis) index[axis] = std::clamp(index[axis], -0.5, grid.size[axis] - 0.5);
  const Vec3 kept_mm = grid.patientFromIndex() * index;
  if (kept_mm == position_mm_) return;
  position_mm_ = kept_mm;
  live_.follow(position_mm_);
  notice_.clear();
  Q_EMIT moved();
}

void Crosshair::goToStart() {
  if (live_.start()) goTo(*live_.start());
}

void Crosshair::goTo(const StartPose& pose) {
  moveTo(pose.position_mm);
  live_.goTo(pose);
}

}  // namespace insonate::prepare
