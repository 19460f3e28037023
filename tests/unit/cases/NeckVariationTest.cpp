#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>
#include <phantom/Variants.h>
#include <phantom/neck/NeckModel.h>
#include <phantom/neck/NeckPoses.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace insonate::phantom {
namespace {

constexpr std::uint32_t kSeeds = 12;

NeckModel neckOf(std::string_view variant, std::uint32_t seed) {
  const auto found = std::ranges::find(variantModels(), variant, [](const auto& v) { return v.about.name; });
  return {std::get<NeckParameters>(found->parameters), seed};
}

/// The labels of one level, finer than a case has them.
struct Level {
  LabelMap labels;

  Level(const NeckModel& neck, double z_mm, Vec3 center_mm, double half_mm, double step_mm) : labels(VolumeGeometry{}) {
    VolumeGeometry grid;
    const int size = 1 + int(std::lround(2 * half_mm / step_mm));
    grid.size = {size, size, 1};
    grid.spacing_mm = {step_mm, step_mm, 1};
    grid.origin_mm = {center_mm.x - half_mm, center_mm.y - half_mm, z_mm};
    labels = neck.rasterise(grid, {}).value();
  }

  std::uint8_t at(Vec3 patient_mm) const {
    patient_mm.z = labels.geometry.origin_mm.z;
    return sampleNearest(labels, labels.geometry.indexFromPatient() * patient_mm);
  }
};

/// Distance from a point in a structure to its edge, by direction.
std::vector<double> outline_mm(const Level& level, Vec3 inside_mm) {
  constexpr int kDirections = 72;
  const std::uint8_t label = level.at(inside_mm);
  std::vector<double> radii;
  for (int n = 0; n < kDirections; ++n) {
    const double angle = 2 * std::numbers::pi * n / kDirections;
    double r = 0;
    while (r < 20 && level.at(inside_mm + Vec3{std::cos(angle), std::sin(angle), 0} * r) == label) r += 0.05;
    radii.push_back(r);
  }
  return radii;
}

/// Mean and Fourier amplitudes of an outline, of the orders up to 4.
std::array<double, 5> ordersOf(const std::vector<double>& radii) {
  std::array<double, 5> orders{};
  for (std::size_t k = 0; k < orders.size(); ++k) {
    double c = 0, s = 0;
    for (std::size_t n = 0; n < radii.size(); ++n) {
      const double angle = 2 * std::numbers::pi * double(k * n) / double(radii.size());
      c += radii[n] * std::cos(angle), s += radii[n] * std::sin(angle);
    }
    orders[k] = (k ? 2 : 1) * std::hypot(c, s) / double(radii.size());
  }
  return orders;
}

/// The middle of the structure about a point.
Vec3 centerd(const Level& level, Vec3 inside_mm) {
  for (int n = 0; n < 4; ++n) {
    const std::vector<double> radii = outline_mm(level, inside_mm);
    Vec3 shift;
    for (std::size_t k = 0; k < radii.size(); ++k) {
      const double angle = 2 * std::numbers::pi * double(k) / double(radii.size());
      shift = shift + Vec3{std::cos(angle), std::sin(angle), 0} * (2 * radii[k] / double(radii.size()));
    }
    inside_mm = inside_mm + shift;
  }
  return inside_mm;
}

Vec3 pointOf(const NeckModel& neck, const std::string& vessel, double z_mm) {
  const std::vector<NamedVessel> all = neck.namedVessels();
  const auto& course = std::ranges::find(all, vessel, &NamedVessel::name)->course;
  return std::ranges::min(course, {}, [&](const auto& p) { return std::abs(p.position_mm.z - z_mm); }).position_mm;
}

struct NearField {
  double skin_mm = 0, muscle_mm = 0;  ///< end of the skin, beginning of the sternocleidomastoid
};

NearField nearField(const Level& level, Vec3 at_mm, Vec3 inward) {
  NearField found;
  double d = -3;
  while (level.at(at_mm + inward * d) == kBackground) d += 0.05;
  const double surface = d;
  while (level.at(at_mm + inward * d) == kSkin) d += 0.05;
  found.skin_mm = d - surface;
  while (d < surface + 25 && level.at(at_mm + inward * d) != kSternocleidomastoid) d += 0.05;
  found.muscle_mm = d - surface;
  return found;
}

TEST(NeckVariation, SkinAndFatUnderTheProbeDifferFromNeckToNeckAndAreUneven) {
  std::vector<double> skin, muscle;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const NeckModel neck = neckOf("textbook", seed);
    const StartPose pose = jugularStartPoses(neck).front();
    const Level level(neck, pose.position_mm.z, pose.position_mm + pose.axial * 10, 22, 0.1);
    std::vector<double> layers;
    for (double aside = -8; aside <= 8; aside += 2) {
      const NearField near = nearField(level, pose.position_mm + pose.lateral * aside, pose.axial);
      layers.push_back(near.muscle_mm);
      if (aside == 0) skin.push_back(near.skin_mm), muscle.push_back(near.muscle_mm);
    }
    const auto [least, most] = std::ranges::minmax(layers);
    EXPECT_GT(most - least, 0.3) << "layers of even thickness";
  }
  const auto [thinSkin, thickSkin] = std::ranges::minmax(skin);
  EXPECT_GT(thinSkin, 0.7);
  EXPECT_LT(thickSkin, 2.8);
  EXPECT_GT(thickSkin - thinSkin, 0.8);
  const auto [shallow, deep] = std::ranges::minmax(muscle);
  EXPECT_GT(deep - shallow, 2);
}

TEST(NeckVariation, ArteriesAreNearlyRoundAndVeinsAreNot) {
  std::vector<double> veinOrder3;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const NeckModel neck = neckOf("textbook", seed);
    const Vec3 artery = pointOf(neck, "right common carotid artery", -26);
    const Level about(neck, artery.z, artery, 8, 0.05);
    const auto round = ordersOf(outline_mm(about, centerd(about, artery)));
    EXPECT_GT(std::hypot(round[2], round[3], round[4]) / round[0], 0.012) << "a circle";
    EXPECT_LT(std::hypot(round[2], round[3], round[4]) / round[0], 0.12);
    const Vec3 vein = neck.jugularCenter_mm(Side::kRight, 0);
    const auto soft = ordersOf(outline_mm({neck, vein.z, vein, 16, 0.1}, vein));
    veinOrder3.push_back(soft[3] / soft[0]);
  }
  std::ranges::sort(veinOrder3);
  EXPECT_GT(veinOrder3[kSeeds / 2], 0.035) << "veins are ellipses";
}

/// Mean length of runs of one label of two along lines in the fat beside the jugular vein.
double meanRun_mm(const NeckModel& neck, double z_mm, bool alongSkin) {
  constexpr double kStep_mm = 0.25, kAxisY_mm = BodySurface::kAxisY_mm;
  const Level level(neck, z_mm, {-40, 40, z_mm}, 40, kStep_mm);
  double length = 0, changes = 0;
  for (double radius = 30; radius < 46; radius += alongSkin ? 0.5 : kStep_mm)
    for (double arc = -18; arc < 18; arc += alongSkin ? kStep_mm : 0.5) {
      const auto labelAt = [&](double r, double a) {
        const double angle = 1.3 + a / 40;
        return level.at({-r * std::sin(angle), kAxisY_mm - r * std::cos(angle), z_mm});
      };
      const auto here = labelAt(radius, arc);
      const auto next = alongSkin ? labelAt(radius, arc + kStep_mm) : labelAt(radius + kStep_mm, arc);
      const auto filler = [](std::uint8_t label) { return label == kFat || label == kSoftTissue; };
      if (!filler(here) || !filler(next)) continue;
      length += kStep_mm;
      changes += here != next;
    }
  return length / changes;
}

TEST(NeckVariation, FatPadsBetweenOrgansAreLongAlongTheSkinAndFlat) {
  double along = 0, across = 0;
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    const NeckModel neck = neckOf("textbook", seed);
    along += meanRun_mm(neck, 12, true), across += meanRun_mm(neck, 12, false);
  }
  EXPECT_GT(along / across, 1.5);
}

struct Views {
  double area_mm2 = 0, depth_mm = 0, overlap_percent = 0;
};

/// The right jugular vein as PhantomTest measures it, on the grid of a case.
Views viewsOf(const NeckModel& neck) {
  const Vec3 vein_mm = neck.jugularCenter_mm(Side::kRight, 0),
             artery_mm = pointOf(neck, "right common carotid artery", 0);
  const Level level(neck, 0, {-30, 15, 0}, 45, 0.5);
  Views views;
  const auto extent = [&](Vec3 inside_mm) {
    std::array<double, 2> x{1e9, -1e9};
    const std::vector<double> radii = outline_mm(level, inside_mm);
    for (std::size_t n = 0; n < radii.size(); ++n) {
      const double at = inside_mm.x + radii[n] * std::cos(2 * std::numbers::pi * double(n) / double(radii.size()));
      x = {std::min(x[0], at), std::max(x[1], at)};
    }
    return x;
  };
  for (const double r : outline_mm(level, vein_mm)) views.area_mm2 += std::numbers::pi * r * r / 72;
  const auto vein = extent(vein_mm), artery = extent(artery_mm);
  views.overlap_percent =
      100 * std::max(0.0, std::min(vein[1], artery[1]) - std::max(vein[0], artery[0])) / (artery[1] - artery[0]);
  const StartPose pose = jugularStartPoses(neck).front();
  while (views.depth_mm < 60 &&
         (views.depth_mm < 6 || level.at(pose.position_mm + pose.axial * views.depth_mm) != kVein))
    views.depth_mm += 0.1;
  return views;
}

TEST(NeckVariation, EachNeckKeepsWhatItsVariantPromises) {
  for (std::uint32_t seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    const Views textbook = viewsOf(neckOf("textbook", seed));
    EXPECT_GT(textbook.depth_mm, 10);
    EXPECT_LT(textbook.depth_mm, 20);
    EXPECT_GT(textbook.area_mm2, 80);
    EXPECT_LT(textbook.area_mm2, 145);
    EXPECT_LT(textbook.overlap_percent, 29);
    EXPECT_LT(viewsOf(neckOf("small-vein", seed)).area_mm2, 0.55 * textbook.area_mm2);
    EXPECT_LT(viewsOf(neckOf("collapsed-vein", seed)).area_mm2, 0.55 * textbook.area_mm2);
    const Views deep = viewsOf(neckOf("deep-in-fat", seed));
    EXPECT_GT(deep.depth_mm, 20);
    EXPECT_LT(deep.depth_mm, 32) << "the beam misses the vein";
    EXPECT_GT(viewsOf(neckOf("vein-over-artery", seed)).overlap_percent, 40);
    EXPECT_GT(viewsOf(neckOf("head-turned", seed)).overlap_percent, 35);
  }
}

TEST(NeckVariation, NamedVesselsLieInTheirVessels) {
  VolumeGeometry grid;
  grid.size = {153, 143, 38};
  grid.spacing_mm = {1, 1, 3};
  grid.origin_mm = {-75.75, -36, -61.5};
  for (std::uint32_t seed = 2; seed < 6; ++seed) {
    const NeckModel neck = neckOf("textbook", seed);
    for (const NamedVessel& vessel : neck.namedVessels()) {
      SCOPED_TRACE(vessel.name + " of " + std::to_string(seed));
      int here = 0, labeled = 0;
      for (const NamedVessel::Point& point : vessel.course) {
        if (!grid.contains(int(std::lround(point.position_mm.x - grid.origin_mm.x)),
                           int(std::lround(point.position_mm.y - grid.origin_mm.y)),
                           int(std::lround((point.position_mm.z - grid.origin_mm.z) / 3))))
          continue;
        ++here;
        labeled += Level(neck, point.position_mm.z, point.position_mm, 1, 0.5).at(point.position_mm) == vessel.label;
      }
      EXPECT_GE(labeled, 0.8 * here);
    }
  }
}

}  // namespace
}  // namespace insonate::phantom
