#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/procedure/TipInView.h>
#include <insonate/teaching/AttemptTrack.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

/// The path of the needle's tip in the image plane, and the section through the patient in this plane. Positions are in
/// the probe frame, in mm: x lateral, y perpendicular to the image plane, z depth.
namespace insonate {

struct PatientCase;

/// Rectangle in the image plane, in mm.
struct PlaneArea {
  double left = 0, right = 0, top = 0, bottom = 0;

  double width() const { return right - left; }
  double height() const { return bottom - top; }
  bool operator==(const PlaneArea&) const = default;
};

/// Piece of the tip's path that is drawn in one style.
struct PathPiece {
  struct Point {
    std::int64_t time_us = 0;
    Vec3 tip_probe{};

    bool operator==(const Point&) const = default;
  };
  NeedlePlace place = NeedlePlace::Clean;
  bool isInSlice = false;  ///< true: the tip is within the image's slice thickness
  std::vector<Point> points{};

  bool operator==(const PathPiece&) const = default;
};

/// Structures in a section, in square pixels. Rows are from top to bottom, columns from left to right.
struct SectionLabels {
  int columns = 0, rows = 0;
  std::vector<std::uint8_t> labels{};  ///< row by row; 0: no structure that a section shows

  std::uint8_t at(int column, int row) const {
    return labels[std::size_t(row) * std::size_t(columns) + std::size_t(column)];
  }
  bool operator==(const SectionLabels&) const = default;
};

/// Returns the point of a track at which the section is taken: the first point in the vein, else the deepest point of
/// the needle; among points with both hands. Null if there is none.
const TrackPoint* sectionPoint(std::span<const TrackPoint> track);
/// Returns the area of the section: the image to the depth `imageDepth_mm`, and the whole path.
PlaneArea sectionArea(std::span<const TrackPoint> track, const ImageField& field, double imageDepth_mm);
/// Returns the structures that a section shows: vessels, bone, airway and lung, skin. Structures are shown as in the
/// CT, without compression.
SectionLabels sectionLabels(const PatientCase& patient, const Transform& patientFromProbe, const PlaneArea& area,
                            double pixel_mm);
/// Returns the path under the skin. Pieces that follow each other without a gap share their end points.
std::vector<PathPiece> pathPieces(std::span<const TrackPoint> track, const ImageField& field);

/// The path of an attempt with its section.
struct NeedlePath {
  std::int64_t time_us = 0;  ///< time of the probe pose that defines the section
  PlaneArea area{};
  std::vector<PathPiece> pieces{};  ///< empty: the needle was never under the skin while the probe was held
  double pixel_mm = 0;
  SectionLabels structures{};

  bool operator==(const NeedlePath&) const = default;
};

/// Computes the path of an attempt, in which neighboring points are at least 0.2 mm apart. Fails if the recording is
/// damaged or its procedure is unknown. Takes about a second for a recording of ten minutes.
Result<NeedlePath> needlePathOf(const AttemptRecording& recording, const PatientCase& patient);

}  // namespace insonate
