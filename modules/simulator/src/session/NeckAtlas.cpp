#include <insonate/cases/Phantom.h>
#include <insonate/simulator/NeckAtlas.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace insonate {
namespace {

constexpr double kVoxel_mm = 5.0 / 3;
constexpr Vec3 kLow_mm{-95, -42, -70}, kHigh_mm{95, 110, 50};  // the model has no head above and no chest below

struct AtlasEntry {
  std::string_view variant;
  std::uint32_t seed;
  bool isMirrored;
};
/// Seeds above 100, so that benches and tests can use others.
constexpr std::array<AtlasEntry, 7> kEntries{{{"textbook", 101, false},
                                              {"vein-over-artery", 102, false},
                                              {"collapsed-vein", 103, true},
                                              {"head-turned", 104, false},
                                              {"deep-in-fat", 105, false},
                                              {"large-sternomastoid", 106, true},
                                              {"head-turned", 107, true}}};

VolumeGeometry atlasGrid() {
  VolumeGeometry g;
  for (int axis = 0; axis < 3; ++axis)
    g.size[axis] = static_cast<int>(std::lround((kHigh_mm[axis] - kLow_mm[axis]) / kVoxel_mm));
  g.spacing_mm = {kVoxel_mm, kVoxel_mm, kVoxel_mm};
  g.origin_mm = kLow_mm + g.spacing_mm / 2;
  return g;
}

/// Exchanges right and left; the grid is symmetric.
void mirror(LabelMap& labels) {
  const auto& size = labels.geometry.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) std::reverse(&labels.at(0, j, k), &labels.at(0, j, k) + size[0]);
}

std::string nameOnOtherSide(std::string_view name) {
  if (name.starts_with("right ")) return "left " + std::string(name.substr(6));
  return "right " + std::string(name.substr(5));
}

AtlasNeck atlasNeck(PhantomLabels neck, bool isMirrored) {
  AtlasNeck result;
  for (std::size_t n = 0; n < kNeckVessels; ++n) {
    const std::string_view name = nameOf(static_cast<NeckStructure>(n));
    const std::string source = isMirrored ? nameOnOtherSide(name) : std::string(name);
    const auto vessel = std::ranges::find(neck.vessels, source, &NamedVessel::name);
    auto& course = result.vessels[n];
    for (const NamedVessel::Point& point : vessel->course) {
      const Vec3& p = point.position_mm;
      course.push_back({{isMirrored ? -p.x : p.x, p.y, p.z}, point.radius_mm});
    }
    if (course.front().position_mm.z > course.back().position_mm.z) std::ranges::reverse(course);
  }
  if (isMirrored) mirror(neck.labels);
  result.labels = std::move(neck.labels);
  return result;
}

}  // namespace

Result<std::vector<AtlasNeck>> makeNeckAtlas(const Progress& progress) {
  std::vector<AtlasNeck> atlas;
  for (const AtlasEntry& entry : kEntries) {
    const Progress part = [&](std::string_view doing, double fraction) {
      return report(progress, doing, (double(atlas.size()) + fraction) / double(kEntries.size()));
    };
    auto neck = phantomLabels(entry.variant, entry.seed, atlasGrid(), part);
    if (!neck) return tl::unexpected(neck.error());
    atlas.push_back(atlasNeck(std::move(*neck), entry.isMirrored));
  }
  return atlas;
}

}  // namespace insonate
