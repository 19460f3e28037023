#pragma once

#include <insonate/core/Result.h>
#include <insonate/segmentation/CenterLine.h>

#include <cstdint>
#include <span>
#include <vector>

namespace insonate {

/// Joins center lines of one label that continue each other: centerLines() ends a line where a section is much larger
/// than its neighbors, for example at a leak. Two ends are joined by a straight line if they are at most 30 mm apart,
/// point toward each other, and have voxels of the label between them.
std::vector<CenterLine> joinedLines(std::vector<CenterLine> lines, const LabelMap& labels, std::uint8_t label);

/// Continues a center line straight on at both ends, while it stays in the label and for at most 25 mm: centerLines()
/// ends a line about the radius of the vessel before the end of the label.
CenterLine extendedToEnds(CenterLine line, const LabelMap& labels, std::uint8_t label);

/// Coordinate system of a cross-section of a vessel, patient space. The three directions are perpendicular unit
/// vectors.
struct VesselFrame {
  Vec3 center_mm;
  Vec3 along;        ///< direction of the vessel
  Vec3 right, down;  ///< directions in the cross-section; the system may be left-handed
};

/// Returns the frames at points on a center line. The directions `right` and `down` of the frame number `given` are
/// made perpendicular to the line there. From this frame to both ends, each frame is rotated about the line as little
/// as possible (double reflection: W. Wang et al., "Computation of rotation minimizing frames", ACM Transactions on
/// Graphics 27, 2008). Needs two or more points, all of them different.
std::vector<VesselFrame> framesAlong(std::span<const Vec3> points_mm, std::size_t given, Vec3 right, Vec3 down);

/// The course of a vessel as frames at equal distances of about a millimeter. The course begins at the end nearer to
/// the head, or, if the vessel is horizontal, at its right or anterior end. In the middle of the course, the directions
/// of a frame are those of a radiological slice: of an axial slice if the vessel is vertical there (right: patient's
/// left, down: posterior), else of a sagittal or a coronal slice.
class VesselCourse {
 public:
  /// Fails if the line is shorter than 5 mm.
  static Result<VesselCourse> make(const CenterLine& line);

  const std::vector<VesselFrame>& frames() const { return frames_; }
  /// Distance between neighboring frames.
  double step_mm() const { return step_mm_; }
  double length_mm() const { return step_mm_ * static_cast<double>(frames_.size() - 1); }
  /// Returns the frame at a distance from the begin of the course, between 0 and length_mm().
  VesselFrame at(double along_mm) const;
  /// Returns the number of the frame whose center is nearest to a point of the patient.
  std::size_t nearest(Vec3 patient_mm) const;

 private:
  std::vector<VesselFrame> frames_;
  double step_mm_ = 1;
};

}  // namespace insonate
