#include "SectionLine.h"

#include <insonate/segmentation/VesselCourse.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

namespace insonate {
namespace {

constexpr double kFrame_mm = 1, kMinCourse_mm = 5;
/// Points to both sides between which the direction of a vessel is measured, and over which the line is averaged.
constexpr std::size_t kTangent = 2;
constexpr int kAverage = 2;

double lineLength_mm(std::span<const Vec3> line) {
  double sum_mm = 0;
  for (std::size_t n = 1; n < line.size(); ++n) sum_mm += norm(line[n] - line[n - 1]);
  return sum_mm;
}

/// Returns `count` points at equal distances along a line, both ends included.
std::vector<Vec3> spaced(std::span<const Vec3> line, std::size_t count) {
  const double step_mm = lineLength_mm(line) / static_cast<double>(count - 1);
  std::vector<Vec3> points{line.front()};
  double before_mm = 0;
  for (std::size_t n = 1; n < line.size(); ++n) {
    const double piece_mm = norm(line[n] - line[n - 1]);
    while (points.size() + 1 < count) {
      const double at_mm = step_mm * static_cast<double>(points.size()) - before_mm;
      if (at_mm > piece_mm) break;
      points.push_back(line[n - 1] + (line[n] - line[n - 1]) * (at_mm / piece_mm));
    }
    before_mm += piece_mm;
  }
  points.push_back(line.back());
  return points;
}

Vec3 directionAt(std::span<const Vec3> points_mm, std::size_t n) {
  const std::size_t back = n > kTangent ? n - kTangent : 0, on = std::min(n + kTangent, points_mm.size() - 1);
  return normalized(points_mm[on] - points_mm[back]);
}

Vec3 perpendicular(Vec3 to, Vec3 direction) {
  return normalized(direction - to * dot(direction, to));
}

/// Carries a direction from one frame to the next by two reflections.
Vec3 carried(const VesselFrame& from, const VesselFrame& to, Vec3 direction) {
  const auto reflected = [](Vec3 v, Vec3 across) {
    const double squared = dot(across, across);
    return squared > 1e-12 ? v - across * (2 * dot(across, v) / squared) : v;
  };
  const Vec3 way = to.center_mm - from.center_mm;
  return reflected(reflected(direction, way), to.along - reflected(from.along, way));
}

int mainAxis(Vec3 direction) {
  int axis = 2;
  for (const int other : {0, 1})
    if (std::abs(direction[other]) > std::abs(direction[axis])) axis = other;
  return axis;
}

/// Returns how far the front of `b` is beyond the end of `a`, if the second line continues the first; else no value.
std::optional<double> gapBetween_mm(const CenterLine& a, const CenterLine& b, const LabelMap& labels,
                                    std::uint8_t label) {
  constexpr double kMaxGap_mm = 30, kMinCosine = 0.8, kMinInside = 0.9;
  const Vec3 way = b.front() - a.back();
  const double gap_mm = norm(way);
  if (gap_mm > kMaxGap_mm) return std::nullopt;
  const auto direction = [](const CenterLine& line, bool isAtEnd) {
    constexpr std::size_t kPoints = 6;
    const std::size_t last = line.size() - 1, some = std::min(kPoints, last);
    return normalized(isAtEnd ? line[last] - line[last - some] : line[some] - line[0]);
  };
  const Vec3 ahead = gap_mm > 1 ? way / gap_mm : direction(a, true);
  if (dot(direction(a, true), ahead) < kMinCosine || dot(direction(b, false), ahead) < kMinCosine) return std::nullopt;
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  constexpr int kSamples = 40;
  int inside = 0;
  for (int n = 0; n < kSamples; ++n)
    inside += sampleNearest(labels, indexFromPatient * (a.back() + way * ((n + 0.5) / kSamples))) == label;
  return inside >= kMinInside * kSamples ? std::optional(gap_mm) : std::nullopt;
}

}  // namespace

CenterLine extendedToEnds(CenterLine line, const LabelMap& labels, std::uint8_t label) {
  constexpr double kStep_mm = 0.5, kMax_mm = 25;
  constexpr std::size_t kPoints = 8;
  if (line.size() < 2) return line;
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  for (int end = 0; end < 2; ++end) {
    std::ranges::reverse(line);
    const std::size_t last = line.size() - 1, some = std::min(kPoints, last);
    const Vec3 last_mm = line[last], ahead = normalized(last_mm - line[last - some]);
    for (double beyond_mm = kStep_mm; beyond_mm <= kMax_mm; beyond_mm += kStep_mm) {
      const Vec3 at_mm = last_mm + ahead * beyond_mm;
      if (sampleNearest(labels, indexFromPatient * at_mm) != label) break;
      line.push_back(at_mm);
    }
  }
  return line;
}

std::vector<CenterLine> joinedLines(std::vector<CenterLine> lines, const LabelMap& labels, std::uint8_t label) {
  struct Joint {
    std::size_t a, b;
    bool isReversedA, isReversedB;
    double gap_mm;
  };
  const auto turned = [](CenterLine line, bool isReversed) {
    if (isReversed) std::ranges::reverse(line);
    return line;
  };
  for (;;) {
    std::optional<Joint> best;
    for (std::size_t a = 0; a < lines.size(); ++a)
      for (std::size_t b = a + 1; b < lines.size(); ++b)
        for (const bool isReversedA : {false, true})
          for (const bool isReversedB : {false, true}) {
            const auto gap_mm =
                gapBetween_mm(turned(lines[a], isReversedA), turned(lines[b], isReversedB), labels, label);
            if (gap_mm && (!best || *gap_mm < best->gap_mm)) best = Joint{a, b, isReversedA, isReversedB, *gap_mm};
          }
    if (!best) return lines;
    CenterLine line = turned(std::move(lines[best->a]), best->isReversedA);
    std::ranges::copy(turned(std::move(lines[best->b]), best->isReversedB), std::back_inserter(line));
    lines[best->a] = std::move(line);
    lines.erase(lines.begin() + std::ptrdiff_t(best->b));
  }
}

std::vector<VesselFrame> framesAlong(std::span<const Vec3> points_mm, std::size_t given, Vec3 right, Vec3 down) {
  std::vector<VesselFrame> frames(points_mm.size());
  for (std::size_t n = 0; n < frames.size(); ++n) {
    frames[n].center_mm = points_mm[n];
    frames[n].along = directionAt(points_mm, n);
  }
  const double handed = dot(cross(right, frames[given].along), down) < 0 ? -1 : 1;
  const auto set = [handed](VesselFrame& frame, Vec3 near) {
    frame.right = perpendicular(frame.along, near);
    frame.down = cross(frame.right, frame.along) * handed;
  };
  set(frames[given], right);
  for (std::size_t n = given + 1; n < frames.size(); ++n)
    set(frames[n], carried(frames[n - 1], frames[n], frames[n - 1].right));
  for (std::size_t n = given; n-- > 0;) set(frames[n], carried(frames[n + 1], frames[n], frames[n + 1].right));
  return frames;
}

Result<VesselCourse> VesselCourse::make(const CenterLine& line) {
  const double whole_mm = lineLength_mm(line);
  if (!(whole_mm >= kMinCourse_mm))
    return fail("This vessel is shorter than 5 mm, so that it has no center line. Label a longer piece of it.");
  const auto count = static_cast<std::size_t>(std::lround(whole_mm / kFrame_mm)) + 1;
  std::vector<Vec3> points = segmentation::smoothed(spaced(line, count), kAverage);
  points = spaced(points, count);
  const Vec3 way = points.back() - points.front();
  const int main = mainAxis(way);
  if (main == 2 ? way.z > 0 : way[main] < 0) std::ranges::reverse(points);
  struct View {
    Vec3 right, down;
  };
  constexpr Vec3 kLeft{1, 0, 0}, kPosterior{0, 1, 0}, kFeet{0, 0, -1};
  constexpr std::array<View, 3> kViews{{{kPosterior, kFeet}, {kLeft, kFeet}, {kLeft, kPosterior}}};
  const std::size_t middle = count / 2;
  const View& view = kViews[std::size_t(mainAxis(directionAt(points, middle)))];
  VesselCourse course;
  course.step_mm_ = lineLength_mm(points) / static_cast<double>(count - 1);
  course.frames_ = framesAlong(points, middle, view.right, view.down);
  return course;
}

VesselFrame VesselCourse::at(double along_mm) const {
  const double place = std::clamp(along_mm / step_mm_, 0.0, static_cast<double>(frames_.size() - 1));
  const auto n = std::min(static_cast<std::size_t>(place), frames_.size() - 2);
  const VesselFrame &a = frames_[n], &b = frames_[n + 1];
  const double part = place - static_cast<double>(n);
  const auto between = [part](Vec3 from, Vec3 to) { return from + (to - from) * part; };
  VesselFrame frame{between(a.center_mm, b.center_mm), normalized(between(a.along, b.along)), {}, {}};
  frame.right = perpendicular(frame.along, between(a.right, b.right));
  const Vec3 down = between(a.down, b.down);
  frame.down = normalized(down - frame.along * dot(down, frame.along) - frame.right * dot(down, frame.right));
  return frame;
}

std::size_t VesselCourse::nearest(Vec3 patient_mm) const {
  const auto found =
      std::ranges::min_element(frames_, {}, [&](const VesselFrame& f) { return norm(f.center_mm - patient_mm); });
  return std::size_t(found - frames_.begin());
}

}  // namespace insonate
