#include "VesselTracer.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::segmentation {
namespace {

constexpr double kStep_mm = 1;
/// Limits of displacement and growth beyond which a section is that of a confluence; one that has shrunk as much is the
/// end of the vessel.
constexpr double kMinJump_mm = 1.5, kJump = 0.3, kGrowth = 2, kMinGrowth_mm2 = 10, kShrinking = 0.25;
/// Weight of a new section in the reference area: a vein may widen, but not within a few millimeters.
constexpr double kForget = 0.1;
/// Number of points that determine the direction: with the last point alone it would follow the voxel steps.
constexpr std::size_t kBaseline = 4;
constexpr double kShortest_mm = 5;
constexpr double kBall_mm = 6, kRim_mm = 2;

/// Removes the noise of single sections from a line; its ends do not change.
void smooth(CenterLine& line) {
  for (int pass = 0; pass < 4; ++pass) {
    Vec3 before_mm = line.front();
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const Vec3 here_mm = line[i];
      line[i] = 0.25 * before_mm + 0.5 * here_mm + 0.25 * line[i + 1];
      before_mm = here_mm;
    }
  }
}

}  // namespace

VesselTracer::VesselTracer(const LabelMap& labels, std::uint8_t label)
    : labels_(labels),
      label_(label),
      finder_(labels, label),
      indexFromPatient_(labels.geometry.indexFromPatient()),
      patientFromIndex_(labels.geometry.patientFromIndex()),
      voxels_(labels.voxels.size(), kOpen) {}

CenterLine VesselTracer::trace(int i, int j, int k, bool evenCut) {
  voxels_[labels_.geometry.offset(i, j, k)] = kRim;
  const Vec3 from_mm = patientFromIndex_ * Vec3{double(i), double(j), double(k)};
  const Start start = startAt(from_mm);
  if (!start.section) return {};
  if (isDone(start.section->center_mm)) {
    // The border of a vessel that a line has passed.
    mark({.center_mm = from_mm, .reach_mm = kRim_mm}, kRim);
    return {};
  }
  if (start.section->cut && !evenCut) {
    voxels_[labels_.geometry.offset(i, j, k)] = kPutOff;
    mark(*start.section, kPutOff);
    return {};
  }
  trail_ = {*start.section};
  CenterLine line = follow(*start.section, -start.axis);
  std::ranges::reverse(line);
  line.push_back(start.section->center_mm);
  std::ranges::copy(follow(*start.section, start.axis), std::back_inserter(line));
  double length_mm = 0, reach_mm = 0;
  for (std::size_t n = 1; n < line.size(); ++n) length_mm += norm(line[n] - line[n - 1]);
  for (const VesselSection& section : trail_) {
    mark(section, kDone);
    reach_mm += section.reach_mm / static_cast<double>(trail_.size());
  }
  if (length_mm < std::max(kShortest_mm, 2 * reach_mm)) return {};
  smooth(line);
  return line;
}

void VesselTracer::reopen() {
  std::ranges::replace(voxels_, std::uint8_t{kPutOff}, std::uint8_t{kOpen});
}

/// Moves from any point in a vessel to its center, and finds its direction.
VesselTracer::Start VesselTracer::startAt(Vec3 from_mm) {
  Vec3 at_mm = from_mm;
  for (int n = 0; n < 8; ++n) at_mm = finder_.middleOfBall(at_mm, kBall_mm);
  Start start;
  for (int n = 0; n < 2; ++n) {
    start = smallestAt(at_mm);
    if (!start.section) return start;
    at_mm = start.section->center_mm;
  }
  for (int n = 0; n < 2; ++n) {
    const auto on = finder_.find(at_mm + start.axis * 2, start.axis);
    const auto back = finder_.find(at_mm - start.axis * 2, start.axis);
    if (!on || !back || norm(on->center_mm - back->center_mm) < 1) break;
    const Vec3 axis = normalized(on->center_mm - back->center_mm);
    const auto section = finder_.find(at_mm, axis);
    if (!section) break;
    start = {section, axis};
    at_mm = section->center_mm;
  }
  return start;
}

/// The section of a vessel is smallest perpendicular to it. Tries the directions to the neighbors in a cube.
VesselTracer::Start VesselTracer::smallestAt(Vec3 at_mm) {
  Start start;
  for (int code = 14; code < 27; ++code) {
    const Vec3 axis = normalized(Vec3{double(code % 3 - 1), double(code / 3 % 3 - 1), double(code / 9 - 1)});
    const auto section = finder_.find(at_mm, axis);
    if (section && (!start.section || section->area_mm2 < start.section->area_mm2)) start = {section, axis};
  }
  return start;
}

CenterLine VesselTracer::follow(const VesselSection& start, Vec3 axis) {
  CenterLine line;
  VesselSection last = start;
  double usual_mm2 = start.area_mm2;
  const auto& size = labels_.geometry.size;
  const std::size_t most = 20 * std::size_t(size[0] + size[1] + size[2]);  // limit for a vessel that forms a ring
  while (line.size() < most) {
    const Vec3 expected_mm = last.center_mm + axis * kStep_mm;
    const auto section = finder_.find(expected_mm, axis);
    if (!section) break;
    // A section cut by the volume's edge has lost area; a section that has grown reaches the edge through another
    // vessel.
    const bool atEdge = section->cut && !start.cut;
    if (section->area_mm2 > (atEdge ? 1 : kGrowth) * usual_mm2 + kMinGrowth_mm2) break;
    if (atEdge) {
      followToEdge(line, last, axis);
      break;
    }
    const double jump_mm = norm(section->center_mm - expected_mm);
    if (jump_mm > std::max(kMinJump_mm, kJump * last.reach_mm) || isDone(section->center_mm) ||
        section->area_mm2 < kShrinking * usual_mm2)
      break;
    usual_mm2 += kForget * (section->area_mm2 - usual_mm2);
    last = *section;
    line.push_back(last.center_mm);
    trail_.push_back(last);
    const bool isLong = line.size() > kBaseline;
    const Vec3 way_mm = last.center_mm - (isLong ? line[line.size() - 1 - kBaseline] : start.center_mm);
    if (norm(way_mm) < 0.5 * kStep_mm) break;
    axis = normalized(way_mm + axis * (isLong ? 0 : static_cast<double>(kBaseline + 1 - line.size())));
  }
  return line;
}

/// Sections at the volume's edge are cut, so that their center is not that of the vessel: the line continues straight.
void VesselTracer::followToEdge(CenterLine& line, VesselSection last, Vec3 axis) {
  for (;;) {
    last.center_mm = last.center_mm + axis * kStep_mm;
    if (sampleNearest(labels_, indexFromPatient_ * last.center_mm) != label_ || isDone(last.center_mm)) return;
    line.push_back(last.center_mm);
    trail_.push_back(last);
  }
}

bool VesselTracer::isDone(Vec3 patient_mm) const {
  const Vec3 index = indexFromPatient_ * patient_mm;
  const int i = static_cast<int>(std::lround(index.x)), j = static_cast<int>(std::lround(index.y)),
            k = static_cast<int>(std::lround(index.z));
  return labels_.geometry.contains(i, j, k) && voxels_[labels_.geometry.offset(i, j, k)] == kDone;
}

void VesselTracer::mark(const VesselSection& section, std::uint8_t as) {
  const VolumeGeometry& g = labels_.geometry;
  const double around_mm = section.reach_mm + 1.5 * std::max({g.spacing_mm.x, g.spacing_mm.y, g.spacing_mm.z});
  const Vec3 center = indexFromPatient_ * section.center_mm;
  std::array<int, 3> first{}, last{};
  for (int axis = 0; axis < 3; ++axis) {
    const double half = around_mm / g.spacing_mm[axis];
    first[axis] = std::max(0, static_cast<int>(std::ceil(center[axis] - half)));
    last[axis] = std::min(g.size[axis] - 1, static_cast<int>(std::floor(center[axis] + half)));
  }
  for (int k = first[2]; k <= last[2]; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i) {
        const Vec3 off{(i - center.x) * g.spacing_mm.x, (j - center.y) * g.spacing_mm.y,
                       (k - center.z) * g.spacing_mm.z};
        std::uint8_t& voxel = voxels_[g.offset(i, j, k)];
        if (dot(off, off) <= around_mm * around_mm && voxel < as) voxel = as;
      }
}

}  // namespace insonate::segmentation
