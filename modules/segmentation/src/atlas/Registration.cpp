#include "Registration.h"

#include <insonate/image/GaussianBlur.h>

#include <algorithm>
#include <cmath>

namespace insonate::segmentation {
namespace {

constexpr int kParameters = 12;  // of a linear map: translation, then the columns of the matrix
constexpr TissueValues kWeights{1.f, 1.f, 1.5f, 0.7f};
constexpr double kMinOverlap = 0.35;
/// Only this part of a neck is compared, about an axis through airway and spine: the shoulders depend on the arms.
constexpr double kCompared_mm = 62, kAxisY_mm = 35;
/// Cost of a linear map that scales or shears, relative to a rotation.
constexpr double kStiffness = 0.15;

bool isCompared(Vec3 neck_mm) {
  return std::hypot(neck_mm.x, neck_mm.y - kAxisY_mm) < kCompared_mm;
}

struct Normal {
  std::array<std::array<double, kParameters>, kParameters> matrix{};
  std::array<double, kParameters> right{};
  double squares = 0, known = 0, all = 0;

  void add(const Normal& other) {
    for (int a = 0; a < kParameters; ++a) {
      right[a] += other.right[a];
      for (int b = 0; b < kParameters; ++b) matrix[a][b] += other.matrix[a][b];
    }
    squares += other.squares, known += other.known, all += other.all;
  }
  double mismatch() const { return known < kMinOverlap * all ? 1e9 : std::sqrt(squares / known); }
};

/// Solves the positive definite system matrix x = right by elimination.
std::vector<double> solved(std::vector<std::vector<double>> matrix, std::vector<double> right) {
  const std::size_t n = right.size();
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a + 1; b < n; ++b) {
      const double factor = matrix[b][a] / matrix[a][a];
      for (std::size_t c = a; c < n; ++c) matrix[b][c] -= factor * matrix[a][c];
      right[b] -= factor * right[a];
    }
  for (std::size_t a = n; a-- > 0;) {
    for (std::size_t c = a + 1; c < n; ++c) right[a] -= matrix[a][c] * right[c];
    right[a] /= matrix[a][a];
  }
  return right;
}

/// Gradient of each tissue value at a continuous index, per mm along the patient's axes.
std::array<Vec3, 4> gradientAt(const CoarseImage& image, Vec3 index) {
  std::array<Vec3, 4> gradient{};
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 before = index, behind = index;
    before[axis] -= 0.5, behind[axis] += 0.5;
    bool knownBefore = false, knownBehind = false;
    const TissueValues a = image.at(before, knownBefore), b = image.at(behind, knownBehind);
    if (!knownBefore || !knownBehind) continue;
    for (std::size_t m = 0; m < a.size(); ++m)
      gradient[m][axis] = double(b[m] - a[m]) / image.geometry.spacing_mm[axis];
  }
  return gradient;
}

Vec3 middleOf(const CoarseImage& image) {
  return image.geometry.center_mm();
}

Normal normalOf(const CoarseImage& ct, const CoarseImage& neck, const Transform& ctFromNeck, bool withMatrix) {
  const Transform neckFromIndex = neck.geometry.patientFromIndex(), indexFromCt = ct.geometry.indexFromPatient();
  const Vec3 middle_mm = middleOf(neck);
  std::vector<Normal> parts(neck.geometry.size[2]);
  tbb::parallel_for(0, neck.geometry.size[2], [&](int k) {
    Normal& part = parts[k];
    for (int j = 0; j < neck.geometry.size[1]; ++j)
      for (int i = 0; i < neck.geometry.size[0]; ++i) {
        const Vec3 at_mm = neckFromIndex * Vec3{double(i), double(j), double(k)};
        if (!isCompared(at_mm)) continue;
        const Vec3 index = indexFromCt * (ctFromNeck * at_mm);
        bool isKnown = false;
        const TissueValues found = ct.at(index, isKnown);
        part.all += 1;
        if (!isKnown) continue;
        part.known += 1;
        const TissueValues& expected = neck.values[neck.geometry.offset(i, j, k)];
        const std::array<Vec3, 4> gradient = withMatrix ? gradientAt(ct, index) : std::array<Vec3, 4>{};
        const Vec3 away_mm = at_mm - middle_mm;
        for (std::size_t m = 0; m < found.size(); ++m) {
          const double off = double(found[m]) - expected[m];
          part.squares += kWeights[m] * off * off;
          if (!withMatrix || gradient[m] == Vec3{}) continue;
          std::array<double, kParameters> slope{};
          for (int row = 0; row < 3; ++row) {
            slope[row] = gradient[m][row];
            for (int column = 0; column < 3; ++column) slope[3 + 3 * column + row] = gradient[m][row] * away_mm[column];
          }
          for (int a = 0; a < kParameters; ++a) {
            part.right[a] -= kWeights[m] * slope[a] * off;
            for (int b = 0; b < kParameters; ++b) part.matrix[a][b] += kWeights[m] * slope[a] * slope[b];
          }
        }
      }
  });
  Normal sum;
  for (const Normal& part : parts) sum.add(part);
  const double stiffness = kStiffness * sum.known;
  for (int column = 0; column < 3; ++column) {
    const Vec3 off = ctFromNeck.linear.column[column] - normalized(ctFromNeck.linear.column[column]);
    for (int row = 0; row < 3; ++row) {
      const int p = 3 + 3 * column + row;
      sum.squares += stiffness * off[row] * off[row];
      sum.right[p] -= stiffness * off[row];
      sum.matrix[p][p] += stiffness;
    }
  }
  return sum;
}

using Direction = std::array<double, kParameters>;

/// Directions in which the parameters may change: translation, rotation and scale, or all.
std::vector<Direction> directionsOf(int stage, const Mat3& linear) {
  std::vector<Direction> directions;
  const int simple = stage == 2 ? kParameters : 3;
  for (int n = 0; n < simple; ++n) directions.emplace_back()[n] = 1;
  if (stage != 1) return directions;
  const auto addChange = [&](const Mat3& change) {
    const Mat3 product = change * linear;
    Direction& direction = directions.emplace_back();
    for (int column = 0; column < 3; ++column)
      for (int row = 0; row < 3; ++row) direction[3 + 3 * column + row] = product.column[column][row];
  };
  addChange(Mat3());
  addChange({{Vec3{0, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}}});
  addChange({{Vec3{0, 0, -1}, Vec3{0, 0, 0}, Vec3{1, 0, 0}}});
  addChange({{Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 0}}});
  return directions;
}

/// One Gauss-Newton step with damping. Stage 0: translation, 1: with rotation and scale, 2: any linear map.
Transform improved(const Normal& normal, const Transform& before, Vec3 middle_mm, int stage) {
  constexpr double kDamping = 0.02;
  const auto directions = directionsOf(stage, before.linear);
  const std::size_t n = directions.size();
  std::vector<std::vector<double>> matrix(n, std::vector<double>(n));
  std::vector<double> right(n);
  for (std::size_t a = 0; a < n; ++a) {
    for (int p = 0; p < kParameters; ++p) right[a] += directions[a][p] * normal.right[p];
    for (std::size_t b = 0; b < n; ++b)
      for (int p = 0; p < kParameters; ++p)
        for (int q = 0; q < kParameters; ++q) matrix[a][b] += directions[a][p] * normal.matrix[p][q] * directions[b][q];
  }
  for (std::size_t a = 0; a < n; ++a) matrix[a][a] = matrix[a][a] * (1 + kDamping) + 1e-9;
  const auto steps = solved(matrix, right);
  Direction change{};
  for (std::size_t a = 0; a < n; ++a)
    for (int p = 0; p < kParameters; ++p) change[p] += steps[a] * directions[a][p];
  Transform after = before;
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row) after.linear.column[column][row] += change[3 + 3 * column + row];
  const Vec3 middle = before * middle_mm + Vec3{change[0], change[1], change[2]};
  after.offset = middle - after.linear * middle_mm;
  return after;
}

/// Improves a map while its mismatch falls.
void descend(const CoarseImage& ct, const CoarseImage& neck, NeckMap& map, int stage, int rounds) {
  Normal normal = normalOf(ct, neck, map.linear, true);
  map.mismatch = normal.mismatch();
  for (int round = 0; round < rounds && map.mismatch < 1e8; ++round) {
    const Transform next = improved(normal, map.linear, middleOf(neck), stage);
    const Normal then = normalOf(ct, neck, next, true);
    if (!(then.mismatch() < map.mismatch * 0.9995)) break;
    normal = then, map.linear = next, map.mismatch = then.mismatch();
  }
}

bool differ(const TissueValues& a, const TissueValues& b) {
  constexpr float kSame = 0.004F;
  for (std::size_t m = 0; m < a.size(); ++m)
    if (std::abs(a[m] - b[m]) > kSame) return true;
  return false;
}

/// Center of the body in a slice of a coarse image; empty if the slice shows no body.
std::optional<Vec3> bodyCenter(const CoarseImage& image, int k) {
  Vec3 sum;
  double weight = 0;
  const Transform patientFromIndex = image.geometry.patientFromIndex();
  for (int j = 0; j < image.geometry.size[1]; ++j)
    for (int i = 0; i < image.geometry.size[0]; ++i) {
      const std::size_t v = image.geometry.offset(i, j, k);
      if (!image.known[v]) continue;
      const double body = 1 - double(image.values[v][3]);
      sum = sum + patientFromIndex * Vec3{double(i), double(j), double(k)} * body;
      weight += body;
    }
  if (weight < 4) return std::nullopt;
  return sum / weight;
}

}  // namespace

Vec3 NeckMap::operator()(Vec3 atlas_mm) const {
  Vec3 to = linear * atlas_mm;
  if (displacement.empty()) return to;
  const Vec3 index = grid.indexFromPatient() * atlas_mm;
  int low[3];
  double part[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double inside = std::clamp(index[axis], 0.0, double(grid.size[axis] - 1));
    low[axis] = std::min(static_cast<int>(inside), std::max(grid.size[axis] - 2, 0));
    part[axis] = inside - low[axis];
  }
  for (int c = 0; c < 8; ++c) {
    const double weight =
        ((c & 1) ? part[0] : 1 - part[0]) * ((c & 2) ? part[1] : 1 - part[1]) * ((c & 4) ? part[2] : 1 - part[2]);
    if (weight == 0) continue;
    to = to + displacement[grid.offset(low[0] + (c & 1), low[1] + ((c >> 1) & 1), low[2] + ((c >> 2) & 1))] * weight;
  }
  return to;
}

std::optional<NeckMap> placeNeck(const CoarseImage& ct, const CoarseImage& neck, Work& work) {
  constexpr double kApart_mm = 10;   // of the levels at which the neck is tried
  constexpr std::size_t kTried = 4;  // of these, the best
  const auto neckCenter = bodyCenter(neck, neck.geometry.size[2] / 2);
  if (!neckCenter) return std::nullopt;
  const int step = std::max(1, static_cast<int>(kApart_mm / ct.geometry.spacing_mm.z));
  std::vector<NeckMap> maps;
  for (int k = 0; k < ct.geometry.size[2]; k += step) {
    work.checkpoint();
    const auto center = bodyCenter(ct, k);
    if (!center) continue;
    NeckMap map;
    map.linear.offset = *center - *neckCenter;
    descend(ct, neck, map, 0, 6);
    if (map.mismatch < 1e8) maps.push_back(std::move(map));
  }
  std::ranges::sort(maps, {}, &NeckMap::mismatch);
  maps.resize(std::min(maps.size(), kTried));
  for (NeckMap& map : maps) {
    work.checkpoint();
    descend(ct, neck, map, 1, 15);
  }
  if (maps.empty()) return std::nullopt;
  return std::ranges::min(maps, {}, &NeckMap::mismatch);
}

void fitLinear(const CoarseImage& ct, const CoarseImage& neck, NeckMap& map, int rounds) {
  descend(ct, neck, map, 2, rounds);
}

void fitDisplacement(const CoarseImage& ct, const CoarseImage& neck, NeckMap& map, int rounds, double sigma_mm,
                     Work& work) {
  const VolumeGeometry& g = neck.geometry;
  const Transform neckFromIndex = g.patientFromIndex(), indexFromCt = ct.geometry.indexFromPatient();
  std::vector<Vec3> start(g.voxelCount());
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Vec3 at_mm = neckFromIndex * Vec3{double(i), double(j), double(k)};
        start[g.offset(i, j, k)] = map(at_mm) - map.linear * at_mm;
      }
  map.grid = g, map.displacement = std::move(start);
  std::array<Volume<float>, 3> part{Volume<float>(g), Volume<float>(g), Volume<float>(g)};
  std::vector<double> squares(g.size[2]), known(g.size[2]);
  const double longest_mm = g.spacing_mm.x / 2;  // of a step
  for (int round = 0; round < rounds; ++round) {
    work.checkpoint();
    tbb::parallel_for(0, g.size[2], [&](int k) {
      squares[k] = known[k] = 0;
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i) {
          const std::size_t v = g.offset(i, j, k);
          const Vec3 at_mm = neckFromIndex * Vec3{double(i), double(j), double(k)};
          const Vec3 index = indexFromCt * (map.linear * at_mm + map.displacement[v]);
          bool isKnown = false;
          const TissueValues found = ct.at(index, isKnown);
          isKnown = isKnown && isCompared(at_mm);
          const TissueValues& expected = neck.values[v];
          Vec3 change;
          if (isKnown) known[k] += 1;
          if (isKnown && differ(found, expected)) {
            const auto inCt = gradientAt(ct, index);
            const auto inNeck = gradientAt(neck, {double(i), double(j), double(k)});
            Vec3 force;
            double weight = 0;
            for (std::size_t m = 0; m < found.size(); ++m) {
              const double off = double(found[m]) - expected[m];
              // The axes of neck and CT are nearly parallel, so that both gradients may be added.
              const Vec3 gradient = (inCt[m] + inNeck[m]) / 2;
              force = force - gradient * (kWeights[m] * off);
              weight += kWeights[m] * (dot(gradient, gradient) + off * off / (4 * longest_mm * longest_mm));
              squares[k] += kWeights[m] * off * off;
            }
            if (weight > 1e-7) change = force / weight;
          }
          const Vec3 next = map.displacement[v] + change;
          for (int axis = 0; axis < 3; ++axis) part[axis].voxels[v] = static_cast<float>(next[axis]);
        }
    });
    for (int axis = 0; axis < 3; ++axis) blurGaussian(part[axis], sigma_mm);
    for (std::size_t v = 0; v < map.displacement.size(); ++v)
      map.displacement[v] = {part[0].voxels[v], part[1].voxels[v], part[2].voxels[v]};
  }
  double sum = 0, count = 0;
  for (int k = 0; k < g.size[2]; ++k) sum += squares[k], count += known[k];
  map.mismatch = count > 0 ? std::sqrt(sum / count) : 1e9;
}

}  // namespace insonate::segmentation
