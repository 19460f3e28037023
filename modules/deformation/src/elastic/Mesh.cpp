#include "elastic/Mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::elastic {
namespace {

constexpr float kQuantum_mm = 2;  // of what is fine, so that the mesh keeps its size while the probe moves
constexpr float kReserve_mm = 4;  // more than needed that is kept
constexpr float kSteepest = 2;    // of the skin against the face
constexpr float kReach = 0.45f;   // of a cell: nodes nearer to an outline are moved onto it

/// How cells grow beyond what is fine.
struct Growth {
  float factor, largest_mm;
};
constexpr Growth kAside{1.4f, 12}, kDown{1.25f, 3};

/// Distances from 0: `fine_mm` in cells of h, then growing to `end_mm`.
std::vector<float> gradedLine(float fine_mm, float h_mm, float end_mm, const Growth& growth) {
  const int cells = std::max(1, static_cast<int>(std::lround(fine_mm / h_mm)));
  std::vector<float> line;
  for (int i = 0; i <= cells; ++i) line.push_back(fine_mm * i / cells);
  for (float h = h_mm; line.back() < end_mm;) {
    h = std::min(h * growth.factor, std::max(growth.largest_mm, h_mm));
    if (end_mm - line.back() < 1.5f * h) {
      line.push_back(end_mm);
      break;
    }
    line.push_back(line.back() + h);
  }
  return line;
}

/// What is needed rounded up; the present where it is enough and not far too much.
float quantised(float needed, float present) {
  if (present >= needed && present <= needed + kReserve_mm) return present;
  return kQuantum_mm * std::ceil((needed + 0.5f) / kQuantum_mm);
}

}  // namespace

void Mesh::chooseLines(const TissuePlane& plane, const ProbeFace& face, const DeformationSettings& settings) {
  constexpr int kColumns = 21, kRows = 21;
  constexpr float kStep_mm = 2;
  std::array<PlanePoint, kColumns * kRows> at;
  std::array<PlaneTissue, kColumns * kRows> found;
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i) at[j * kColumns + i] = {(i - kColumns / 2) * kStep_mm, j * kStep_mm};
  plane.sample(at, found);
  float half = static_cast<float>(face.width_mm) / 2 + 4, deepest = 10;
  for (std::size_t k = 0; k < at.size(); ++k)
    if (std::min(found[k].artery_mm, found[k].vein_mm) < 1) {
      half = std::max(half, std::abs(at[k].x_mm) + 2);
      deepest = std::max(deepest, at[k].z_mm + 3);
    }
  const float h = static_cast<float>(settings.mesh_mm), depth = static_cast<float>(settings.depth_mm);
  half = quantised(half, lines_.fineHalf_mm);
  deepest = std::min(quantised(deepest, lines_.fineDepth_mm), 0.8f * depth);
  if (half == lines_.fineHalf_mm && deepest == lines_.fineDepth_mm && lines_.depth_mm.back() == depth) return;
  lines_.fineHalf_mm = half;
  lines_.fineDepth_mm = deepest;
  lines_.depth_mm = gradedLine(deepest, h, depth, kDown);
  const std::vector<float> right = gradedLine(half, h, half + kBeyond_mm, kAside);
  lines_.x_mm.clear();
  for (std::size_t i = right.size() - 1; i > 0; --i) lines_.x_mm.push_back(-right[i]);
  lines_.x_mm.insert(lines_.x_mm.end(), right.begin(), right.end());
}

void Mesh::findSkin(const TissuePlane& plane) {
  const int n = columns();
  skin_.assign(n, 0.0f);
  points_.resize(std::size_t(n) * rows());
  tissue_.resize(std::size_t(n) * rows());
  const std::span<PlanePoint> at(points_.data(), n);
  const std::span<PlaneTissue> found(tissue_.data(), n);
  for (int round = 0; round < 10; ++round) {
    for (int i = 0; i < n; ++i) at[i] = {lines_.x_mm[i], skin_[i]};
    plane.sample(at, found);
    for (int i = 0; i < n; ++i) skin_[i] = std::clamp(skin_[i] + found[i].skin_mm, -kMostSkin_mm, kMostSkin_mm);
  }
  for (int i = 1; i < n; ++i)
    skin_[i] = std::min(skin_[i], skin_[i - 1] + kSteepest * (lines_.x_mm[i] - lines_.x_mm[i - 1]));
  for (int i = n - 2; i >= 0; --i)
    skin_[i] = std::min(skin_[i], skin_[i + 1] + kSteepest * (lines_.x_mm[i + 1] - lines_.x_mm[i]));
}

void Mesh::build(const TissuePlane& plane, const ProbeFace& face, const DeformationSettings& settings) {
  if (lines_.depth_mm.empty()) lines_.depth_mm = {0};
  chooseLines(plane, face, settings);
  findSkin(plane);
  const int nx = columns(), nz = rows();
  const std::size_t nodes = std::size_t(nx) * nz;
  if (rest_.x.size() != nodes + GridMatrix::kPadding) rest_.resize(nodes);
  const float depth = lines_.depth_mm.back();
  for (int j = 0; j < nz; ++j)
    for (int i = 0; i < nx; ++i) {
      const std::size_t n = std::size_t(j) * nx + i;
      rest_.x[n] = lines_.x_mm[i];
      rest_.z[n] = skin_[i] + lines_.depth_mm[j] * (depth - skin_[i]) / depth;
      points_[n] = {rest_.x[n], rest_.z[n]};
    }
  plane.sample(points_, tissue_);
  snap();
}

void Mesh::snap() {
  const int nx = columns(), nz = rows();
  for (int j = 1; j + 1 < nz; ++j)
    for (int i = 1; i + 1 < nx; ++i) {
      const std::size_t n = std::size_t(j) * nx + i;
      PlaneTissue& here = tissue_[n];
      float PlaneTissue::*nearest = &PlaneTissue::bone_mm;
      for (const auto other : {&PlaneTissue::artery_mm, &PlaneTissue::vein_mm})
        if (std::abs(here.*other) < std::abs(here.*nearest)) nearest = other;
      const float distance = here.*nearest;
      const PlanePoint *left = &points_[n - 1], *right = &points_[n + 1], *up = &points_[n - nx],
                       *down = &points_[n + nx];
      const float cell = std::min(right->x_mm - left->x_mm, down->z_mm - up->z_mm) / 2;
      if (std::abs(distance) >= kReach * cell) continue;
      // Along x the grid follows the skin, so its lines are not square to each other.
      const float dz = (tissue_[n + nx].*nearest - tissue_[n - nx].*nearest) / (down->z_mm - up->z_mm);
      const float dx = (tissue_[n + 1].*nearest - tissue_[n - 1].*nearest - dz * (right->z_mm - left->z_mm)) /
                       (right->x_mm - left->x_mm);
      const float squared = dx * dx + dz * dz;
      if (squared < 0.25f) continue;
      rest_.x[n] -= distance * dx / squared;
      rest_.z[n] -= distance * dz / squared;
      snapped_.push_back({n, nearest});
    }
  for (const Snapped& s : snapped_) tissue_[s.node].*s.outline = 0;
  snapped_.clear();
}

Mesh::Place Mesh::placeOf(float x_mm, float z_mm) const {
  const auto along = [](const std::vector<float>& line, float value) {
    const auto above = std::upper_bound(line.begin() + 1, line.end() - 1, value);
    const float low = *(above - 1);
    return std::clamp(float(above - 1 - line.begin()) + (value - low) / (*above - low), 0.0f, float(line.size() - 1));
  };
  Place place;
  place.column = along(lines_.x_mm, x_mm);
  const int c = std::min(static_cast<int>(place.column), columns() - 2);
  const float skin = skin_[c] + (place.column - c) * (skin_[c + 1] - skin_[c]);
  const float depth = lines_.depth_mm.back();
  place.row = along(lines_.depth_mm, (z_mm - skin) * depth / (depth - skin));
  return place;
}

}  // namespace insonate::elastic
