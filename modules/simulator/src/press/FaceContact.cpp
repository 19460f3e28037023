#include "press/FaceContact.h"

#include <insonate/deformation/FaceProfile.h>

#include <algorithm>
#include <cmath>

namespace insonate::press {
namespace {

constexpr float kAbove_mm = 22, kBelow_mm = 40, kStep_mm = 0.5F;
constexpr int kRows = 1 + static_cast<int>((kAbove_mm + kBelow_mm) / kStep_mm);
constexpr double kColumn_mm = 1;
/// Tissue over bone keeps at least a tenth of its thickness.
constexpr double kSqueezed = 0.9;

float rowAt(int row) {
  return -kAbove_mm + row * kStep_mm;
}

/// Position at which a quantity crosses 0 between a row and the next.
float crossing(int row, float here, float next) {
  return rowAt(row) + kStep_mm * std::clamp(here / (here - next), 0.0F, 1.0F);
}

/// The skin nearest to the face: behind it if the face is in the body, else in front of it.
std::optional<float> skinOf(std::span<const PlaneTissue> column, float face_mm) {
  const int start = std::clamp(static_cast<int>(std::lround((face_mm + kAbove_mm) / kStep_mm)), 1, kRows - 2);
  if (column[start].skin_mm < 0) {
    for (int r = start; r > 0; --r)
      if (column[r - 1].skin_mm >= 0) return crossing(r - 1, column[r - 1].skin_mm, column[r].skin_mm);
    return {};
  }
  for (int r = start; r + 1 < kRows; ++r)
    if (column[r + 1].skin_mm < 0) return crossing(r, column[r].skin_mm, column[r + 1].skin_mm);
  return {};
}

double boneOf(std::span<const PlaneTissue> column, float skin_mm) {
  const int start = std::clamp(static_cast<int>(std::floor((skin_mm + kAbove_mm) / kStep_mm)), 0, kRows - 1);
  for (int r = start; r + 1 < kRows; ++r)
    if (column[r + 1].bone_mm <= 0)
      return crossing(r, std::max(column[r].bone_mm, 0.0F), column[r + 1].bone_mm - 1e-6F);
  return HUGE_VAL;
}

}  // namespace

FaceContact::FaceContact(const ProbeFace& face) {
  const FaceProfile profile(face);
  const float half = profile.reach_mm() - 1e-3F;
  const int count = 1 + static_cast<int>(std::ceil(2 * half / kColumn_mm));
  for (int c = 0; c < count; ++c) {
    const float x_mm = -half + 2 * half * static_cast<float>(c) / static_cast<float>(count - 1);
    columns_.push_back({x_mm, profile.at(x_mm).z_mm});
  }
  for (const Column& column : columns_)
    for (int r = 0; r < kRows; ++r) points_.push_back({column.x_mm, rowAt(r)});
  tissue_.resize(points_.size());
}

std::optional<FaceTravel> FaceContact::find(const TissuePlane& plane) {
  plane.sample(points_, tissue_);
  FaceTravel travel{HUGE_VAL, HUGE_VAL};
  for (std::size_t c = 0; c < columns_.size(); ++c) {
    const std::span<const PlaneTissue> column(tissue_.data() + c * kRows, kRows);
    const auto skin_mm = skinOf(column, columns_[c].face_mm);
    if (!skin_mm) continue;
    const double bone_mm = boneOf(column, *skin_mm), face_mm = columns_[c].face_mm;
    travel.touch_mm = std::min(travel.touch_mm, *skin_mm - face_mm);
    travel.deepest_mm = std::min(travel.deepest_mm, *skin_mm + kSqueezed * (bone_mm - *skin_mm) - face_mm);
  }
  if (!std::isfinite(travel.touch_mm)) return {};
  return travel;
}

}  // namespace insonate::press
