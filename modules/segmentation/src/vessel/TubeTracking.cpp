#include "ClosedWay.h"
#include "Guarded.h"
#include "LumenFill.h"
#include "SectionLine.h"
#include "SectionShape.h"

#include <insonate/segmentation/Brush.h>
#include <insonate/segmentation/TubeTracking.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using segmentation::RadialCost;
using segmentation::SectionShape;
using segmentation::Work;

constexpr double kStep_mm = 0.25;
constexpr int kRounds = 6;
constexpr int kAveraged = 4, kLineStations = 3, kShapeStations = 5;  // stations on both sides
constexpr int kMedianStations = 4;                                   // stations whose median is the expected outline
constexpr double kMaxUnlike = 4;
constexpr double kClick_mm = 1.5;  // radius of the ball that determines the tissue to follow

/// CT levels of the vessel to follow, from the CT around the clicks.
struct TubeLevel {
  double middle_HU = 0, darker_HU = 0, brighter_HU = 0, blur_mm = 0;

  double unlikeness(double hu) const {
    const double off = hu < middle_HU ? (middle_HU - hu) / darker_HU : (hu - middle_HU) / brighter_HU;
    return std::min(off * off, kMaxUnlike);
  }
};

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + std::ptrdiff_t(values.size() / 2));
  return values[values.size() / 2];
}

TubeLevel levelAt(const CtVolume& ct, std::span<const Vec3> clicks_mm, const TubeTracking& how) {
  constexpr double kSdPerDeviation = 1.48;  // ratio of SD to median absolute deviation, normal distribution
  constexpr double kQuiet_HU = 12, kVoxelsPerNoise = 1.0 / 20, kMaxVoxels = 1.2;  // of blur
  // Averaging along the line leaves more noise with fewer slices; the limit is that of usual slices.
  constexpr double kUsualSlice_mm = 0.75;
  constexpr double kDarkerNoise = 0.6, kBrighterNoise = 0.4;
  std::vector<double> all, deviations;
  for (const Vec3& click_mm : clicks_mm) {
    const Selection ball = strokeVoxels(ct.geometry, std::array{click_mm}, {.radius_mm = kClick_mm});
    std::vector<double> here;
    for (int k = ball.box.first[2]; k < ball.box.end[2]; ++k)
      for (int j = ball.box.first[1]; j < ball.box.end[1]; ++j)
        for (int i = ball.box.first[0]; i < ball.box.end[0]; ++i)
          if (ball.isSelected(i, j, k)) here.push_back(ct.at(i, j, k));
    all.insert(all.end(), here.begin(), here.end());
    const double middle = median(here);
    for (const double hu : here) deviations.push_back(std::abs(hu - middle));
  }
  const Vec3& spacing_mm = ct.geometry.spacing_mm;
  const double thick_mm = std::max({spacing_mm.x, spacing_mm.y, spacing_mm.z});
  const double noise_HU = kSdPerDeviation * median(deviations);
  const double left_HU = noise_HU * std::sqrt(thick_mm / kUsualSlice_mm);
  const double voxel_mm = std::min({spacing_mm.x, spacing_mm.y, spacing_mm.z});
  return {median(all), std::max(how.darker_HU, kDarkerNoise * left_HU),
          std::max(how.brighter_HU, kBrighterNoise * left_HU),
          std::clamp((noise_HU - kQuiet_HU) * kVoxelsPerNoise, 0.0, kMaxVoxels) * voxel_mm};
}

/// A smooth line through the clicks: E. Catmull, R. Rom, "A class of local interpolating splines", 1974.
std::vector<Vec3> lineThrough(std::span<const Vec3> clicks_mm) {
  constexpr int kParts = 32;
  std::vector<Vec3> line;
  for (std::size_t n = 0; n + 1 < clicks_mm.size(); ++n) {
    const Vec3 b = clicks_mm[n], c = clicks_mm[n + 1];
    const Vec3 a = n > 0 ? clicks_mm[n - 1] : b * 2 - c;
    const Vec3 d = n + 2 < clicks_mm.size() ? clicks_mm[n + 2] : c * 2 - b;
    for (int part = 0; part < kParts; ++part) {
      const double t = double(part) / kParts;
      line.push_back(
          (b * 2 + (c - a) * t + (a * 2 - b * 5 + c * 4 - d) * (t * t) + (b * 3 - a - c * 3 + d) * (t * t * t)) * 0.5);
    }
  }
  line.push_back(clicks_mm.back());
  return segmentation::resampled(line);
}

class TubeFit {
 public:
  TubeFit(const CtVolume& ct, const TubeLevel& level, const TubeTracking& how, Work& work)
      : ct_(ct), indexFromPatient_(ct.geometry.indexFromPatient()), level_(level), how_(how), work_(work) {}

  TrackedVessel follow(const std::vector<Vec3>& line) {
    sections_ = segmentation::sectionsAlong(line);
    shapes_.resize(sections_.size());
    for (int round = 0; round < kRounds; ++round) {
      if (round > 0) center();
      fit();
    }
    TrackedVessel tube;
    for (std::size_t n = 0; n < sections_.size(); ++n) {
      sections_[n].radius_mm = shapes_[n].unstretched(sections_[n].radius_mm);
      tube.line.push_back(sections_[n].center_mm);
    }
    tube.outlines = std::move(sections_);
    return tube;
  }

 private:
  /// The sum of (unlikeness - 1) up to each wall, from means over the neighboring sections, stretched like this
  /// section.
  RadialCost costAt(int n) const {
    const int count = static_cast<int>(sections_.size());
    const int first = std::max(0, n - kAveraged), last = std::min(count - 1, n + kAveraged);
    RadialCost wall(static_cast<int>(how_.largest_mm / kStep_mm), kStep_mm);
    for (int ray = 0; ray < VesselOutline::kRays; ++ray) {
      const auto [x, y] = shapes_[n].along(ray);
      const double length = std::hypot(x, y);
      double sum = 0;
      for (int r = 0; r < wall.steps; ++r) {
        const double away_mm = kStep_mm * (r + 0.5);
        double hu = 0;
        for (int m = first; m <= last; ++m) {
          const VesselOutline& s = sections_[m];
          hu += sampleLinear(ct_, indexFromPatient_ * (s.center_mm + (s.right * x + s.down * y) * away_mm));
        }
        sum += (level_.unlikeness(hu / (last - first + 1)) - 1) * length;
        wall.at(ray, r) = sum;
      }
    }
    return wall;
  }

  void fit() {
    const auto bendAt = [this](int) { return segmentation::Bend{.stiffness = how_.stiffness}; };
    std::vector<RadialCost> walls(sections_.size(), RadialCost(0, kStep_mm));
    work_.slices(static_cast<int>(sections_.size()), [&](int n) {
      walls[n] = costAt(n);
      sections_[n].radius_mm = segmentation::closedWay(walls[n], bendAt, nullptr);
    });
    for (int again = 0; again < 2; ++again) {
      const auto expected = segmentation::likeNeighbors(sections_, kMedianStations);
      for (std::size_t n = 0; n < sections_.size(); ++n)
        sections_[n].radius_mm = segmentation::closedWay(walls[n], bendAt, &expected[n]);
    }
  }

  /// Moves the line onto the centers of the outlines; the stretch is the mean of the outlines around.
  void center() {
    const int count = static_cast<int>(sections_.size());
    std::vector<Vec3> line;
    std::vector<segmentation::SectionMoments> moments;
    for (int n = 0; n < count; ++n) {
      moments.push_back(shapes_[n].momentsOf(sections_[n].radius_mm));
      line.push_back(sections_[n].center_mm + sections_[n].right * moments[n].x + sections_[n].down * moments[n].y);
    }
    sections_ = segmentation::sectionsAlong(segmentation::smoothed(line, kLineStations));
    for (int n = 0; n < count; ++n) shapes_[n] = SectionShape(segmentation::meanMoments(moments, n, kShapeStations));
  }

  const CtVolume& ct_;
  Transform indexFromPatient_;
  const TubeLevel& level_;
  const TubeTracking& how_;
  Work& work_;
  std::vector<VesselOutline> sections_;  ///< with radii in the stretch of the shapes
  std::vector<SectionShape> shapes_;
};

}  // namespace

Result<TrackedVessel> trackTube(const CtVolume& ct, std::span<const Vec3> clicks_mm, const TubeTracking& how,
                                const Progress& progress) {
  if (auto ok = segmentation::checkClicks(ct, clicks_mm); !ok) return tl::unexpected(ok.error());
  return segmentation::guarded([&] {
    Work work(progress, kRounds);
    work.start("Following the tube");
    const TubeLevel level = levelAt(ct, clicks_mm, how);
    const auto around = boxAround(ct.geometry, clicks_mm, 2 * how.largest_mm + 10);
    const CtVolume part = segmentation::blurredPart(ct, around, level.blur_mm);
    TrackedVessel tube = TubeFit(part, level, how, work).follow(lineThrough(clicks_mm));
    tube.lumen = segmentation::fillLumen(ct.geometry, tube.outlines);
    return tube;
  });
}

}  // namespace insonate
