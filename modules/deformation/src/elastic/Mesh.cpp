#include "elastic/Mesh.h"

#include <algorithm>
#include <cmath>

namespace insonate::elastic {
namespace {

constexpr float kAround_mm = 1.5f;        // of vessels, skin and ends of the face: range of the fine cells
constexpr float kDeepest_mm = 33;         // that a moving probe may keep before the mesh changes its size
constexpr std::size_t kSpareBlocks = 10;  // additional blocks that a moving probe may keep before the mesh changes its
                                          // size
constexpr float kSteepest = 2;            // slope of the skin relative to the face
constexpr float kReach = 0.45f;           // of a cell: nodes nearer to an outline are moved onto it

/// Growth of cells outside the fine part.
struct Growth {
  float factor, largest_mm;
};
constexpr Growth kAside{1.4f, 12}, kDown{1.25f, 3};

/// Cells that grow from `h_mm` until `end_mm`.
void grow(std::vector<float>& line, float h_mm, float end_mm, const Growth& growth) {
  for (float h = h_mm; line.back() < end_mm;) {
    h = std::min(h * growth.factor, std::max(growth.largest_mm, h_mm));
    line.push_back(end_mm - line.back() < 1.5f * h ? end_mm : line.back() + h);
  }
}

/// Begins after the first point of the first block, which exists already.
void addBlocks(std::vector<float>& line, const FineBlocks& blocks) {
  for (std::size_t k = 0; k < blocks.fine.size(); ++k) {
    const float from = blocks.first_mm + blocks.size_mm * float(k);
    if (blocks.fine[k]) line.push_back(from + blocks.size_mm / 2);
    line.push_back(from + blocks.size_mm);
  }
}

}  // namespace

void FineBlocks::mark(float from_mm, float to_mm) {
  const int last = static_cast<int>(fine.size()) - 1;
  const int from = std::max(0, static_cast<int>(std::floor((from_mm - first_mm) / size_mm)));
  const int to = std::min(last, static_cast<int>(std::ceil((to_mm - first_mm) / size_mm)) - 1);
  for (int k = from; k <= to; ++k) fine[k] = 1;
}

bool FineBlocks::serves(const FineBlocks& needed) const {
  if (first_mm != needed.first_mm || size_mm != needed.size_mm || fine.size() < needed.fine.size()) return false;
  std::size_t spare = fine.size() - needed.fine.size();
  for (std::size_t k = 0; k < needed.fine.size(); ++k) {
    if (needed.fine[k] && !fine[k]) return false;
    spare += fine[k] && !needed.fine[k];
  }
  return spare <= kSpareBlocks;
}

/// From coarse samples of the plane.
void Mesh::findNeed(const TissuePlane& plane, const ProbeFace& face, const DeformationSettings& settings) {
  constexpr int kColumns = 25, kRows = 24;
  constexpr float kStep_mm = 2;
  static const std::vector<float> kX_mm = [] {
    std::vector<float> x;
    for (int i = 0; i < kColumns; ++i) x.push_back(float(i - kColumns / 2) * kStep_mm);
    return x;
  }();
  const float depth = static_cast<float>(settings.depth_mm), block = 2 * static_cast<float>(settings.mesh_mm);
  const float end = static_cast<float>(face.width_mm) / 2;
  const float half = block * std::ceil(std::max(end + 4, kX_mm.back()) / block);
  FineBlocks &across = needed_.across, &down = needed_.down;
  across.first_mm = -half, across.size_mm = down.size_mm = block;
  across.fine.assign(std::lround(2 * half / block), 0);
  down.fine.assign(static_cast<int>(std::floor(std::min(0.8f * depth, kDeepest_mm) / block)), 0);
  down.mark(0, kAround_mm);
  // The contact of a flat face ends at its ends, that of a round one anywhere.
  for (const float x : {-end, end}) across.mark(x - kAround_mm, x + kAround_mm);
  if (face.radius_mm > 0) across.mark(-end, end);

  findSkin(plane, kX_mm, skin_);
  points_.resize(std::max(points_.size(), std::size_t(kColumns) * kRows));
  tissue_.resize(points_.size());
  for (int j = 0; j < kRows; ++j)
    for (int i = 0; i < kColumns; ++i) points_[j * kColumns + i] = {kX_mm[i], skin_[i] + (float(j) + 0.5f) * kStep_mm};
  plane.sample({points_.data(), kColumns * kRows}, {tissue_.data(), kColumns * kRows});
  for (int k = 0; k < kColumns * kRows; ++k) {
    const float near = std::min(tissue_[k].artery_mm, tissue_[k].vein_mm);
    if (near > 1) continue;
    const float reach = kAround_mm + std::clamp(near + 1, 0.0f, 1.0f);
    const float skin = skin_[k % kColumns], below = (points_[k].z_mm - skin) * depth / (depth - skin);
    across.mark(points_[k].x_mm - reach, points_[k].x_mm + reach);
    down.mark(below - reach, below + reach);
  }
  while (down.fine.size() > 10 && !down.fine.back()) down.fine.pop_back();
}

void Mesh::chooseLines(const TissuePlane& plane, const ProbeFace& face, const DeformationSettings& settings) {
  findNeed(plane, face, settings);
  const float depth = static_cast<float>(settings.depth_mm);
  if (!lines_.x_mm.empty() && lines_.across.serves(needed_.across) && lines_.down.serves(needed_.down) &&
      lines_.depth_mm.back() == depth)
    return;
  lines_.across = needed_.across;
  lines_.down = needed_.down;
  lines_.depth_mm.assign(1, lines_.down.first_mm);
  addBlocks(lines_.depth_mm, lines_.down);
  grow(lines_.depth_mm, lines_.down.size_mm, depth, kDown);
  // Beside the blocks, symmetric on both sides.
  const float end_mm = lines_.across.end_mm();
  aside_.assign(1, end_mm);
  grow(aside_, lines_.across.size_mm, end_mm + kBeyond_mm, kAside);
  lines_.x_mm.clear();
  for (std::size_t i = aside_.size() - 1; i > 0; --i) lines_.x_mm.push_back(-aside_[i]);
  lines_.x_mm.push_back(lines_.across.first_mm);
  addBlocks(lines_.x_mm, lines_.across);
  lines_.x_mm.back() = end_mm;
  lines_.x_mm.insert(lines_.x_mm.end(), aside_.begin() + 1, aside_.end());
}

void Mesh::findSkin(const TissuePlane& plane, const std::vector<float>& x_mm, std::vector<float>& skin_mm) {
  const int n = static_cast<int>(x_mm.size());
  skin_mm.assign(n, 0.0f);
  points_.resize(std::max(points_.size(), std::size_t(n)));
  tissue_.resize(points_.size());
  const std::span<PlanePoint> at(points_.data(), n);
  const std::span<PlaneTissue> found(tissue_.data(), n);
  for (int round = 0; round < 10; ++round) {
    for (int i = 0; i < n; ++i) at[i] = {x_mm[i], skin_mm[i]};
    plane.sample(at, found);
    for (int i = 0; i < n; ++i) skin_mm[i] = std::clamp(skin_mm[i] + found[i].skin_mm, -kMaxSkin_mm, kMaxSkin_mm);
  }
  for (int i = 1; i < n; ++i) skin_mm[i] = std::min(skin_mm[i], skin_mm[i - 1] + kSteepest * (x_mm[i] - x_mm[i - 1]));
  for (int i = n - 2; i >= 0; --i)
    skin_mm[i] = std::min(skin_mm[i], skin_mm[i + 1] + kSteepest * (x_mm[i + 1] - x_mm[i]));
}

void Mesh::build(const TissuePlane& plane, const ProbeFace& face, const DeformationSettings& settings) {
  chooseLines(plane, face, settings);
  findSkin(plane, lines_.x_mm, skin_);
  const int nx = columns(), nz = rows();
  const std::size_t nodes = std::size_t(nx) * nz;
  points_.resize(nodes);
  tissue_.resize(nodes);
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
  classifyCells(plane);
}

void Mesh::classifyCells(const TissuePlane& plane) {
  const std::size_t nx = columns(), cells = nx * (rows() - 1) - 1;
  middle_.resize(cells);
  for (std::size_t n = 0; n < cells; ++n)
    points_[n] = {(rest_.x[n] + rest_.x[n + 1] + rest_.x[n + nx] + rest_.x[n + nx + 1]) / 4,
                  (rest_.z[n] + rest_.z[n + 1] + rest_.z[n + nx] + rest_.z[n + nx + 1]) / 4};
  plane.sample({points_.data(), cells}, middle_);
}

void Mesh::snap() {
  const int nx = columns(), nz = rows();
  for (int j = 1; j + 1 < nz; ++j)
    for (int i = 1; i + 1 < nx; ++i) {
      const std::size_t n = std::size_t(j) * nx + i;
      const PlaneTissue& tissue = tissue_[n];
      const struct { float x, z; } here{points_[n].x_mm, points_[n].z_mm};
      float PlaneTissue::*nearest = &PlaneTissue::bone_mm;
      for (const auto other : {&PlaneTissue::artery_mm, &PlaneTissue::vein_mm})
        if (std::abs(tissue.*other) < std::abs(tissue.*nearest)) nearest = other;
      const float distance = tissue.*nearest;
      const PlanePoint *left = &points_[n - 1], *right = &points_[n + 1], *up = &points_[n - nx],
                       *down = &points_[n + nx];
      const float cell = std::min({right->x_mm - here.x, here.x - left->x_mm, down->z_mm - here.z, here.z - up->z_mm});
      if (std::abs(distance) >= kReach * cell) continue;
      // Along x the grid follows the skin, so that its lines are not perpendicular.
      const float dz = (tissue_[n + nx].*nearest - tissue_[n - nx].*nearest) / (down->z_mm - up->z_mm);
      const float dx = (tissue_[n + 1].*nearest - tissue_[n - 1].*nearest - dz * (right->z_mm - left->z_mm)) /
                       (right->x_mm - left->x_mm);
      const float squared = dx * dx + dz * dz;
      // Except at an outline, distances change by less than a millimeter for each millimeter.
      if (squared < 0.25f || std::abs(distance) >= kReach * cell * std::sqrt(squared)) continue;
      rest_.x[n] -= distance * dx / squared;
      rest_.z[n] -= distance * dz / squared;
      snapped_.push_back({n, nearest});
    }
  for (const Snapped& s : snapped_) tissue_[s.node].*s.outline = 0;
  snapped_.clear();
}

void Mesh::takeShape(const Mesh& other) {
  lines_ = other.lines_;
  rest_ = other.rest_;
  skin_ = other.skin_;
}

Mesh::Place Mesh::placeOf(float x_mm, float z_mm, std::size_t guess) const {
  const auto along = [](const std::vector<float>& line, float value, int k) {
    const int last = static_cast<int>(line.size()) - 2;
    k = std::min(k, last);
    while (k > 0 && line[k] > value) --k;
    while (k < last && line[k + 1] <= value) ++k;
    return std::clamp(float(k) + (value - line[k]) / (line[k + 1] - line[k]), 0.0f, float(last + 1));
  };
  Place place;
  place.column = along(lines_.x_mm, x_mm, static_cast<int>(guess % columns()));
  const int c = std::min(static_cast<int>(place.column), columns() - 2);
  const float skin = skin_[c] + (place.column - c) * (skin_[c + 1] - skin_[c]);
  const float depth = lines_.depth_mm.back();
  place.row = along(lines_.depth_mm, (z_mm - skin) * depth / (depth - skin), static_cast<int>(guess / columns()));
  return place;
}

}  // namespace insonate::elastic
