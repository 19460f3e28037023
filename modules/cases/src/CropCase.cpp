#include <insonate/cases/CropCase.h>
#include <insonate/tissue/Labels.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace insonate {
namespace {

/// A point between two samples of an axis: the index of the lower sample, and the weight of the upper one.
struct Tap {
  int low = 0, high = 0;
  float share = 0;
};

/// Sample points of one new voxel along one axis, evenly distributed over it.
using Taps = std::vector<Tap>;

std::vector<Taps> tapsAlong(int axis, const VolumeGeometry& from, const VolumeGeometry& to) {
  const Vec3 first = from.indexFromPatient() * to.origin_mm;
  const double step = to.spacing_mm[axis] / from.spacing_mm[axis];
  const int points = std::max(1, static_cast<int>(std::lround(std::ceil(step - 1e-9))));
  std::vector<Taps> taps;
  for (int n = 0; n < to.size[axis]; ++n) {
    taps.emplace_back();
    for (int p = 0; p < points; ++p) {
      const double within = (p + 0.5) / points - 0.5;
      const double at = std::clamp(first[axis] + (n + within) * step, 0.0, from.size[axis] - 1.0);
      // A limit that coincides with a voxel includes only that voxel, independent of rounding.
      const double whole = std::round(at);
      const double index = std::abs(at - whole) < 1e-6 ? whole : at;
      const int low = static_cast<int>(index);
      taps.back().push_back({low, std::min(low + 1, from.size[axis] - 1), static_cast<float>(index - low)});
    }
  }
  return taps;
}

struct AllTaps {
  std::array<std::vector<Taps>, 3> along;

  /// Calls `take` with each voxel that contributes to a new one, and its weight.
  template <class Take>
  void each(int i, int j, int k, Take take) const {
    for (const Tap& z : along[2][static_cast<std::size_t>(k)])
      for (const Tap& y : along[1][static_cast<std::size_t>(j)])
        for (const Tap& x : along[0][static_cast<std::size_t>(i)])
          for (int corner = 0; corner < 8; ++corner) {
            const bool right = corner & 1, below = corner & 2, above = corner & 4;
            const float weight =
                (right ? x.share : 1 - x.share) * (below ? y.share : 1 - y.share) * (above ? z.share : 1 - z.share);
            if (weight > 0) take(right ? x.high : x.low, below ? y.high : y.low, above ? z.high : z.low, weight);
          }
  }
};

std::int16_t meanHu(const CtVolume& ct, const AllTaps& taps, int i, int j, int k) {
  double sum = 0, weights = 0;
  taps.each(i, j, k, [&](int x, int y, int z, float weight) {
    sum += double(weight) * ct.at(x, y, z);
    weights += weight;
  });
  return static_cast<std::int16_t>(std::lround(sum / weights));
}

/// Takes the lowest number if two labels have the same share.
std::uint8_t largestLabel(const LabelMap& labels, const AllTaps& taps, int i, int j, int k,
                          std::array<float, 256>& shares) {
  std::array<std::uint8_t, 256> seen{};
  std::size_t count = 0;
  taps.each(i, j, k, [&](int x, int y, int z, float weight) {
    const std::uint8_t label = labels.at(x, y, z);
    if (shares[label] == 0) seen[count++] = label;
    shares[label] += weight;
  });
  std::uint8_t best = seen[0];
  for (std::size_t n = 1; n < count; ++n)
    if (shares[seen[n]] > shares[best] || (shares[seen[n]] == shares[best] && seen[n] < best)) best = seen[n];
  for (std::size_t n = 0; n < count; ++n) shares[seen[n]] = 0;
  return best;
}

std::string text(const VolumeGeometry& g) {
  const auto number = [](double value) {
    std::array<char, 32> rounded;
    std::snprintf(rounded.data(), rounded.size(), "%.3f", value);
    std::string digits = rounded.data();
    while (digits.ends_with('0')) digits.pop_back();
    if (digits.ends_with('.')) digits.pop_back();
    return digits;
  };
  return std::to_string(g.size[0]) + "x" + std::to_string(g.size[1]) + "x" + std::to_string(g.size[2]) + " voxels of " +
         number(g.spacing_mm.x) + "x" + number(g.spacing_mm.y) + "x" + number(g.spacing_mm.z) + " mm";
}

/// Faces between a voxel of a vein and a voxel of an artery, including the author's own labels.
class VesselFaces {
 public:
  VesselFaces(const OwnLabels& own, const LabelMap& labels) : labels_(labels) {
    for (int label = 0; label < 256; ++label) tissue_[std::size_t(label)] = tissueOf(own, std::uint8_t(label));
  }

  bool isVessel(std::uint8_t label) const { return tissue_[label] == kVein || tissue_[label] == kArtery; }
  /// Calls `take` with the voxels of each face; stops if `take` returns false.
  template <class Take>
  void each(Take take) const {
    const VolumeGeometry& g = labels_.geometry;
    for (int k = 0; k < g.size[2]; ++k)
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i)
          for (int axis = 0; axis < 3; ++axis) {
            const std::array<int, 3> here{i, j, k}, next{i + (axis == 0), j + (axis == 1), k + (axis == 2)};
            if (!g.contains(next[0], next[1], next[2])) continue;
            const std::uint8_t a = tissue_[labels_.at(i, j, k)], b = tissue_[labels_.at(next[0], next[1], next[2])];
            if (((a == kVein && b == kArtery) || (a == kArtery && b == kVein)) && !take(here, next)) return;
          }
  }

 private:
  const LabelMap& labels_;
  std::array<std::uint8_t, 256> tissue_{};
};

/// Tissue other than vessels in a new voxel: its most frequent label, and the share of the voxel.
struct WallShare {
  std::uint8_t label = 0;
  float share = 0;
};

WallShare wallIn(const LabelMap& labels, const AllTaps& taps, const VesselFaces& faces, std::array<int, 3> at) {
  std::array<float, 256> shares{};
  float all = 0;
  taps.each(at[0], at[1], at[2], [&](int x, int y, int z, float weight) {
    const std::uint8_t label = labels.at(x, y, z);
    all += weight;
    if (!faces.isVessel(label)) shares[label] += weight;
  });
  const auto most = std::ranges::max_element(shares);
  return {static_cast<std::uint8_t>(most - shares.begin()), *most / all};
}

/// The wall between two vessels may be thinner than a new voxel, in which the vessels then have the larger share. Of
/// the two voxels that touch, the one with more of the wall becomes wall. Returns the number of faces without any wall.
std::size_t keepWalls(const PatientCase& patient, const AllTaps& taps, LabelMap& labels) {
  constexpr float kMinWall = 0.1F;
  const VesselFaces faces(patient.manifest.ownLabels, labels);
  std::size_t left = 0;
  faces.each([&](std::array<int, 3> a, std::array<int, 3> b) {
    const WallShare inA = wallIn(patient.labels, taps, faces, a), inB = wallIn(patient.labels, taps, faces, b);
    const auto& [at, wall] = inA.share >= inB.share ? std::pair(a, inA) : std::pair(b, inB);
    if (wall.share >= kMinWall)
      labels.at(at[0], at[1], at[2]) = wall.label;
    else
      ++left;
    return true;
  });
  return left;
}

bool haveVesselsTouched(const PatientCase& patient) {
  bool touched = false;
  VesselFaces(patient.manifest.ownLabels, patient.labels).each([&touched](auto, auto) { return !(touched = true); });
  return touched;
}

/// Removes targets, vessels and landmarks outside the grid.
void keepInside(CaseManifest& manifest, const VolumeGeometry& grid) {
  const auto drop = [&](const std::string& kind, const std::string& name, Vec3 place_mm) {
    const auto [i, j, k] = nearestVoxel(grid.indexFromPatient() * place_mm);
    if (grid.contains(i, j, k)) return false;
    manifest.importNotes.push_back("The " + kind + " \"" + name + "\" was outside the kept part and was removed.");
    return true;
  };
  std::erase_if(manifest.targets, [&](const Target& one) { return drop("target", one.name, one.position_mm); });
  std::erase_if(manifest.vessels, [&](const NamedVessel& one) {
    return std::ranges::none_of(one.course, [&](const NamedVessel::Point& point) {
      const auto [i, j, k] = nearestVoxel(grid.indexFromPatient() * point.position_mm);
      return grid.contains(i, j, k);
    });
  });
  std::erase_if(manifest.landmarks, [&](const Landmark& one) {
    return drop("landmark", one.name.empty() ? one.code : one.name, one.position_mm);
  });
}

}  // namespace

VoxelBox boxBetween(const VolumeGeometry& geometry, Vec3 corner_mm, Vec3 opposite_mm) {
  const Transform indexFromPatient = geometry.indexFromPatient();
  Vec3 low = indexFromPatient * corner_mm, high = low;
  // Uses all eight corners, since the grid may be oblique to the patient's axes.
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p =
        indexFromPatient * Vec3{corner & 1 ? opposite_mm.x : corner_mm.x, corner & 2 ? opposite_mm.y : corner_mm.y,
                                corner & 4 ? opposite_mm.z : corner_mm.z};
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  }
  VoxelBox box;
  for (int a = 0; a < 3; ++a) {
    box.first[a] = static_cast<int>(std::clamp(std::ceil(low[a] - 1e-6), 0.0, double(geometry.size[a])));
    box.end[a] = static_cast<int>(std::clamp(std::floor(high[a] + 1e-6) + 1, 0.0, double(geometry.size[a])));
  }
  return box;
}

Result<VolumeGeometry> croppedGrid(const VolumeGeometry& geometry, const CropOptions& options) {
  if (options.box.empty() || intersected(options.box, boxOf(geometry)) != options.box)
    return fail(
        "The region to keep contains no voxel of the case, or reaches beyond it. Choose a region within the CT.");
  VolumeGeometry grid = gridOf(geometry, options.box);
  if (!options.spacing_mm) return grid;
  if (auto ok = checkVoxelSize(*options.spacing_mm); !ok) return tl::unexpected(ok.error());
  Vec3 shift;
  for (int a = 0; a < 3; ++a) {
    const double length_mm = grid.size[a] * grid.spacing_mm[a], step_mm = (*options.spacing_mm)[a];
    grid.size[a] = std::max(1, static_cast<int>(std::lround(length_mm / step_mm)));
    // Both grids have the same center.
    shift[a] = (length_mm - grid.spacing_mm[a]) / 2 - (grid.size[a] - 1) * step_mm / 2;
    grid.spacing_mm[a] = step_mm;
  }
  grid.origin_mm = grid.origin_mm + grid.direction * shift;
  constexpr double kMaxVoxels = 2e9;
  if (double(grid.size[0]) * grid.size[1] * grid.size[2] > kMaxVoxels)
    return fail("That would be " + text(grid) + ", more than Insonate can handle. Choose a larger spacing.");
  if (auto ok = validate(grid); !ok) return tl::unexpected(ok.error());
  return grid;
}

Result<PatientCase> cropCase(const PatientCase& patient, const CropOptions& options, const Progress& progress) {
  const auto grid = croppedGrid(patient.ct.geometry, options);
  if (!grid) return tl::unexpected(grid.error());
  PatientCase part{patient.manifest, CtVolume(*grid), LabelMap(*grid), patient.colors};
  AllTaps taps;
  for (int a = 0; a < 3; ++a) taps.along[a] = tapsAlong(a, patient.ct.geometry, *grid);
  for (int k = 0; k < grid->size[2]; ++k) {
    if (!report(progress, "Cropping", double(k) / grid->size[2])) return fail(std::string(kCancelled));
    tbb::parallel_for(0, grid->size[1], [&](int j) {
      std::array<float, 256> shares{};
      for (int i = 0; i < grid->size[0]; ++i) {
        part.ct.at(i, j, k) = meanHu(patient.ct, taps, i, j, k);
        part.labels.at(i, j, k) = largestLabel(patient.labels, taps, i, j, k, shares);
      }
    });
  }
  part.manifest.importNotes.push_back((options.spacing_mm ? "Cropped and resampled from " : "Cropped from ") +
                                      text(patient.ct.geometry) + " to " + text(*grid) + ".");
  keepInside(part.manifest, *grid);
  const std::size_t touching = options.spacing_mm ? keepWalls(patient, taps, part.labels) : 0;
  if (touching > 0 && !haveVesselsTouched(patient))
    part.manifest.importNotes.push_back(
        "Vein and artery touch at " + std::to_string(touching) + (touching == 1 ? " voxel" : " voxels") +
        ", since the wall between them is thinner than the new voxels. Choose a smaller spacing, or separate them.");
  report(progress, "Cropping", 1);
  return part;
}

}  // namespace insonate
