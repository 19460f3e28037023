#include <insonate/cases/Difficulty.h>
#include <insonate/cases/StartPose.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace insonate {
namespace {

constexpr double kStep_mm = 0.25, kHalfWidth_mm = 30, kDeepest_mm = 80;
constexpr int kColumns = int(2 * kHalfWidth_mm / kStep_mm) + 1, kRows = int(kDeepest_mm / kStep_mm) + 1;

/// A section at a right angle to a vessel: rows go into the body from the skin, the middle column through the target.
struct Section {
  std::vector<std::uint8_t> labels;
  std::uint8_t at(int column, int row) const { return labels[std::size_t(row) * kColumns + std::size_t(column)]; }
};

/// A connected region of a section.
struct Region {
  std::vector<std::array<int, 2>> pixels;  ///< column, row
  double area_mm2() const { return double(pixels.size()) * kStep_mm * kStep_mm; }
};

/// Direction of the vessel: the main axis of its voxels near the target, by power iteration. None if they have no main
/// axis, as in a vessel that is wider than the ball in which they are collected.
std::optional<Vec3> directionOf(const CaseView& patient, const Target& target) {
  constexpr double kReach_mm = 10, kGrain_mm = 1;
  const Transform index = patient.labels.geometry.indexFromPatient();
  std::vector<Vec3> offsets;
  Vec3 mean;
  const int n = int(kReach_mm / kGrain_mm);
  for (int k = -n; k <= n; ++k)
    for (int j = -n; j <= n; ++j)
      for (int i = -n; i <= n; ++i) {
        const Vec3 offset = kGrain_mm * Vec3{double(i), double(j), double(k)};
        if (norm(offset) > kReach_mm ||
            sampleNearest(patient.labels, index * (target.position_mm + offset)) != target.label)
          continue;
        offsets.push_back(offset);
        mean = mean + offset;
      }
  mean = mean / std::max(1.0, double(offsets.size()));
  Vec3 along{0.1, 0.1, 1};  // most vessels of the neck are vertical
  for (int turn = 0; turn < 60; ++turn) {
    Vec3 next;
    for (const Vec3& offset : offsets) next = next + dot(offset - mean, along) * (offset - mean);
    if (norm(next) < 1e-9) break;
    along = normalized(next);
  }
  along = normalized(along);
  double lengthwise = 0, all = 0;
  for (const Vec3& offset : offsets) {
    lengthwise += std::pow(dot(offset - mean, along), 2);
    all += dot(offset - mean, offset - mean);
  }
  // Ratio of the variance along the vessel to the mean of the other two: 15 for a round vessel of 6 mm, 2 for one of
  // 16 mm or a vein of 20 x 8 mm, 1 for what fills the ball.
  constexpr double kClear = 1.8;
  if (lengthwise < kClear * (all - lengthwise) / 2) return std::nullopt;
  return along;
}

/// The nearest start pose that aims at the target, else one on the nearest skin.
Result<StartPose> poseToward(const CaseView& patient, const Target& target) {
  constexpr double kAims_mm = 12;
  double nearest_mm = std::numeric_limits<double>::infinity();
  const StartPose* nearest = nullptr;
  for (const StartPose& pose : patient.manifest.startPoses) {
    const Vec3 to = target.position_mm - pose.position_mm;
    const double deep = dot(to, pose.axial);
    if (deep <= 0 || norm(to - deep * pose.axial) > kAims_mm || norm(to) >= nearest_mm) continue;
    nearest_mm = norm(to), nearest = &pose;
  }
  return nearest ? Result<StartPose>(*nearest) : proposeStartPoseOver(patient, target);
}

/// Distance from the target back to the last point of the body before 5 mm of outside.
double toSkin_mm(const CaseView& patient, Vec3 from_mm, Vec3 outward) {
  constexpr double kOutside_mm = 5;
  const Transform index = patient.labels.geometry.indexFromPatient();
  double last = 0;
  for (double s = 0; s < kDeepest_mm && s - last < kOutside_mm; s += kStep_mm)
    if (sampleNearest(patient.labels, index * (from_mm + s * outward)) != kBackground) last = s;
  return last;
}

Region regionAround(const Section& section, std::uint8_t label, int column, int row, std::vector<char>& seen) {
  Region region;
  const auto add = [&](int c, int r) {
    if (c < 0 || r < 0 || c >= kColumns || r >= kRows || section.at(c, r) != label) return;
    char& known = seen[std::size_t(r) * kColumns + std::size_t(c)];
    if (known) return;
    known = 1;
    region.pixels.push_back({c, r});
  };
  add(column, row);
  for (std::size_t n = 0; n < region.pixels.size(); ++n) {
    const auto [c, r] = region.pixels[n];
    add(c + 1, r), add(c - 1, r), add(c, r + 1), add(c, r - 1);
  }
  return region;
}

Vec3 centerOf(const Region& region) {
  Vec3 sum;
  for (const auto& [c, r] : region.pixels) sum = sum + Vec3{double(c), double(r), 0};
  return sum / double(region.pixels.size());
}

/// Axes of the ellipse with the same second moments: four standard deviations each.
void measureShape(const Region& vein, VeinMeasures& m) {
  const Vec3 center = centerOf(vein);
  double xx = 0, yy = 0, xy = 0;
  for (const auto& [c, r] : vein.pixels) {
    const double x = c - center.x, y = r - center.y;
    xx += x * x, yy += y * y, xy += x * y;
  }
  const double n = double(vein.pixels.size()), mid = (xx + yy) / 2 / n;
  const double spread = std::hypot((xx - yy) / 2, xy) / n;
  m.area_mm2 = vein.area_mm2();
  m.width_mm = 4 * std::sqrt(mid + spread) * kStep_mm;
  m.height_mm = 4 * std::sqrt(std::max(0.0, mid - spread)) * kStep_mm;
}

double gap_mm(const Region& a, const Region& b) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [c, r] : a.pixels)
    for (const auto& [x, y] : b.pixels) nearest = std::min(nearest, double((c - x) * (c - x) + (r - y) * (r - y)));
  return std::max(0.0, std::sqrt(nearest) - 1) * kStep_mm;
}

/// `back` is the posterior direction of the patient, in columns and rows.
void measureArteries(const Section& section, const Region& vein, Vec3 back, VeinMeasures& m) {
  constexpr double kArtery_mm2 = 6, kReach_mm = 15;  // area of a branch 3 mm thick; smaller ones are ignored
  std::vector<char> seen(section.labels.size());
  std::vector<std::pair<double, Region>> arteries;
  for (int r = 0; r < kRows; ++r)
    for (int c = 0; c < kColumns; ++c) {
      Region region = regionAround(section, kArtery, c, r, seen);
      if (region.area_mm2() < kArtery_mm2) continue;
      const double gap = gap_mm(vein, region);
      if (gap < kReach_mm) arteries.emplace_back(gap, std::move(region));
    }
  if (arteries.empty()) return;
  std::ranges::sort(arteries, {}, [](const auto& one) { return one.first; });
  const Region& artery = arteries.front().second;
  m.artery_mm = arteries.front().first;
  if (arteries.size() > 1) m.second_mm = arteries[1].first;
  const auto acrossOf = [&](const std::array<int, 2>& p) { return p[0] * back.y - p[1] * back.x; };
  const auto extentOf = [&](const Region& region) {
    const auto [low, high] = std::ranges::minmax(region.pixels, {}, acrossOf);
    return std::pair(acrossOf(low), acrossOf(high));
  };
  const auto [left, right] = extentOf(vein);
  const auto [first, last] = extentOf(artery);
  const Vec3 to = centerOf(artery) - centerOf(vein);
  const double behind = dot(to, back), aside = to.x * back.y - to.y * back.x;
  m.angle_deg = std::abs(std::atan2(aside, behind)) * 180 / std::numbers::pi;
  const double both = std::min(right, last) - std::max(left, first) + 1;
  const auto shareOf = [&](double width) { return std::clamp(100 * both / width, 0.0, 100.0); };
  m.overlap_percent = behind > 0 ? shareOf(last - first + 1) : 0.0;
  m.covered_percent = behind < 0 ? shareOf(right - left + 1) : 0.0;
}

void measureLung(const Section& section, const Region& vein, VeinMeasures& m) {
  const int column = int(std::lround(centerOf(vein).x));
  const auto back = std::ranges::max(vein.pixels, {}, [](const auto& p) { return p[1]; })[1];
  for (int r = back; r < kRows; ++r)
    if (section.at(column, r) == kAirway) {
      m.lung_mm = (r - back) * kStep_mm;
      return;
    }
}

}  // namespace

Result<VeinMeasures> measureVein(const CaseView& patient, const Target& target) {
  const Transform index = patient.labels.geometry.indexFromPatient();
  if (sampleNearest(patient.labels, index * target.position_mm) != target.label)
    return fail("The target \"" + target.name + "\" is not in " + labelName(target.label) +
                ". Move the target into its vessel, or label the vessel there.");
  const auto pose = poseToward(patient, target);
  if (!pose) return tl::unexpected(pose.error());
  const Vec3 beam = pose->axial;
  // A vessel under a probe lies across the beam. A label of which other tissue is a part may have its main axis along
  // the beam; the section would then leave the beam and look for the skin far away.
  constexpr double kAcross = 0.55;
  std::optional<Vec3> main = directionOf(patient, target);
  if (main && std::abs(dot(*main, beam)) > kAcross) main.reset();
  const Vec3 along = main.value_or(normalized(cross(beam, pose->lateral)));
  Vec3 into = beam - dot(beam, along) * along;
  if (norm(into) < 0.2) into = beam;  // the beam is along the vessel: any section is suitable
  into = normalized(into);
  const Vec3 aside = normalized(cross(along, into));
  const double skin_mm = toSkin_mm(patient, target.position_mm, -into);
  const Vec3 skin = target.position_mm - skin_mm * into;

  Section section;
  section.labels.reserve(std::size_t(kColumns) * kRows);
  for (int r = 0; r < kRows; ++r)
    for (int c = 0; c < kColumns; ++c)
      section.labels.push_back(
          sampleNearest(patient.labels, index * (skin + r * kStep_mm * into + (c * kStep_mm - kHalfWidth_mm) * aside)));
  std::vector<char> seen(section.labels.size());
  const Region vein = regionAround(section, target.label, kColumns / 2, int(std::lround(skin_mm / kStep_mm)), seen);
  if (vein.pixels.empty())
    return fail("The target \"" + target.name +
                "\" lies on the edge of its vessel. Move the target into the middle of the vessel.");
  VeinMeasures measures;
  measures.target = target.name;
  measures.depth_mm = std::ranges::min(vein.pixels, {}, [](const auto& p) { return p[1]; })[1] * kStep_mm;
  measureShape(vein, measures);
  constexpr Vec3 kBackward{0, 1, 0};
  const Vec3 back{dot(kBackward, aside), dot(kBackward, into), 0};
  measureArteries(section, vein, norm(back) > 0.3 ? normalized(back) : Vec3{0, 1, 0}, measures);
  measureLung(section, vein, measures);
  return measures;
}

}  // namespace insonate
