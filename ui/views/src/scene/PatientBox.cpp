#include "PatientBox.h"

#include <algorithm>
#include <limits>

namespace insonate::views {
namespace {

void empty(double box[6]) {
  for (int axis = 0; axis < 3; ++axis) {
    box[2 * axis] = std::numeric_limits<double>::max();
    box[2 * axis + 1] = std::numeric_limits<double>::lowest();
  }
}

void include(Vec3 point, double box[6]) {
  for (int axis = 0; axis < 3; ++axis) {
    box[2 * axis] = std::min(box[2 * axis], point[axis]);
    box[2 * axis + 1] = std::max(box[2 * axis + 1], point[axis]);
  }
}

}  // namespace

bool patientBox(const SceneState& state, const VtkCase* patient, double box[6]) {
  empty(box);
  for (const auto& shape : state.shapes) {
    if (!shape) continue;
    const double* own = shape->box;
    include({own[0], own[2], own[4]}, box);
    include({own[1], own[3], own[5]}, box);
  }
  if (box[0] <= box[1]) return true;
  if (!patient) return false;
  ctBox(*patient, box);
  return true;
}

void pointsBox(std::span<const float> points_mm, double box[6]) {
  empty(box);
  for (std::size_t k = 0; k + 2 < points_mm.size(); k += 3)
    include({points_mm[k], points_mm[k + 1], points_mm[k + 2]}, box);
}

void ctBox(const VtkCase& patient, double box[6]) {
  const VolumeGeometry& grid = patient.patient().ct.geometry;
  const Transform patientFromIndex = grid.patientFromIndex();
  empty(box);
  for (int corner = 0; corner < 8; ++corner)
    include(patientFromIndex * Vec3{corner & 1 ? grid.size[0] - 0.5 : -0.5, corner & 2 ? grid.size[1] - 0.5 : -0.5,
                                    corner & 4 ? grid.size[2] - 0.5 : -0.5},
            box);
}

}  // namespace insonate::views
