#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/procedure/ProcedureRun.h>
#include <insonate/teaching/NeedlePath.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace insonate {
namespace {

constexpr double kAside_mm = 3, kAbove_mm = 5, kSmallestWidth_mm = 30, kSmallestDepth_mm = 20;
constexpr double kPathStep_mm = 0.2, kSectionPixel_mm = 0.5;

bool isOnPath(const TrackPoint& point) {
  return point.needleDepth_mm && point.tip_probe;
}

bool isShownInSection(std::uint8_t label) {
  return label == kVein || label == kArtery || label == kBone || label == kAirway || label == kSkin;
}

/// Removes points that are closer to their predecessor than a drawing can show. The ends of a piece stay.
void thin(PathPiece& piece) {
  std::vector<PathPiece::Point> kept;
  for (std::size_t i = 0; i < piece.points.size(); ++i) {
    const Vec3 step = kept.empty() ? Vec3{} : piece.points[i].tip_probe - kept.back().tip_probe;
    const bool isEnd = i == 0 || i + 1 == piece.points.size();
    if (isEnd || dot(step, step) >= kPathStep_mm * kPathStep_mm) kept.push_back(piece.points[i]);
  }
  piece.points = std::move(kept);
}

/// The last sample at or before a time.
Result<AttemptSample> sampleAt(const AttemptRecording& recording, std::int64_t time_us) {
  AttemptSample last;
  const auto played = recording.play(time_us, [&](const RecordingSegment::Entry& entry) {
    if (const auto* sample = std::get_if<AttemptSample>(&entry)) last = *sample;
  });
  if (!played) return tl::unexpected(played.error());
  return last;
}

}  // namespace

const TrackPoint* sectionPoint(std::span<const TrackPoint> track) {
  const TrackPoint* deepest = nullptr;
  for (const TrackPoint& point : track) {
    if (!isOnPath(point)) continue;
    if (point.place == NeedlePlace::Vein) return &point;
    if (!deepest || *point.needleDepth_mm > *deepest->needleDepth_mm) deepest = &point;
  }
  return deepest;
}

PlaneArea sectionArea(std::span<const TrackPoint> track, const ImageField& field, double imageDepth_mm) {
  const double half_mm = std::max(field.width_mm, kSmallestWidth_mm) / 2;
  PlaneArea area{.left = -half_mm, .right = half_mm, .top = -kAbove_mm, .bottom = kSmallestDepth_mm};
  for (const TrackPoint& point : track) {
    if (!isOnPath(point)) continue;
    area.left = std::min(area.left, point.tip_probe->x - kAside_mm);
    area.right = std::max(area.right, point.tip_probe->x + kAside_mm);
    area.bottom = std::max(area.bottom, point.tip_probe->z + kAside_mm);
  }
  area.bottom = std::max(area.bottom, imageDepth_mm);
  return area;
}

SectionLabels sectionLabels(const PatientCase& patient, const Transform& patientFromProbe, const PlaneArea& area,
                            double pixel_mm) {
  const Transform indexFromProbe = patient.labels.geometry.indexFromPatient() * patientFromProbe;
  SectionLabels section{.columns = int(area.width() / pixel_mm), .rows = int(area.height() / pixel_mm)};
  section.labels.reserve(std::size_t(section.columns) * std::size_t(section.rows));
  for (int row = 0; row < section.rows; ++row)
    for (int column = 0; column < section.columns; ++column) {
      const Vec3 at_mm{area.left + (column + 0.5) * pixel_mm, 0, area.top + (row + 0.5) * pixel_mm};
      const std::uint8_t label = sampleNearest(patient.labels, indexFromProbe * at_mm);
      section.labels.push_back(isShownInSection(label) ? label : std::uint8_t{0});
    }
  return section;
}

std::vector<PathPiece> pathPieces(std::span<const TrackPoint> track, const ImageField& field) {
  std::vector<PathPiece> pieces;
  bool isBroken = true;
  for (const TrackPoint& point : track) {
    if (!isOnPath(point)) {
      isBroken = true;
      continue;
    }
    const bool isInSlice = std::abs(point.tip_probe->y) <= maxOffPlane_mm(field, point.tip_probe->z);
    if (isBroken || pieces.back().place != point.place || pieces.back().isInSlice != isInSlice) {
      PathPiece next{.place = point.place, .isInSlice = isInSlice};
      if (!isBroken) next.points.push_back(pieces.back().points.back());
      pieces.push_back(std::move(next));
      isBroken = false;
    }
    pieces.back().points.push_back({point.time_us, *point.tip_probe});
  }
  return pieces;
}

Result<NeedlePath> needlePathOf(const AttemptRecording& recording, const PatientCase& patient) {
  auto procedure = builtInProcedure(recording.header().procedure);
  if (!procedure) return tl::unexpected(procedure.error());
  const AttemptHeader& header = recording.header();
  ProcedureRun run(std::move(*procedure), header.picture, header.vessels);
  std::vector<TrackPoint> track;
  const auto played =
      recording.play(std::numeric_limits<std::int64_t>::max(), [&](const RecordingSegment::Entry& entry) {
        std::visit([&](const auto& what) { run.add(what); }, entry);
        if (const auto* sample = std::get_if<AttemptSample>(&entry)) addToTrack(track, *sample, run.metrics().needle());
      });
  if (!played) return tl::unexpected(played.error());
  NeedlePath path;
  const TrackPoint* point = sectionPoint(track);
  if (!point) return path;
  const auto sample = sampleAt(recording, point->time_us);
  if (!sample) return tl::unexpected(sample.error());
  path.time_us = point->time_us;
  path.area = sectionArea(track, header.picture, sample->imageDepth_mm);
  path.pieces = pathPieces(track, header.picture);
  for (PathPiece& piece : path.pieces) thin(piece);
  path.pixel_mm = kSectionPixel_mm;
  if (sample->patientFromProbe)
    path.structures = sectionLabels(patient, *sample->patientFromProbe, path.area, path.pixel_mm);
  return path;
}

}  // namespace insonate
