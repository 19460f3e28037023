#include "MprDrawing.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insonate::views {
namespace {

constexpr double kOutlineAlone = 0.9;
/// Maximum distance of a place through which a slice counts as passing.
constexpr double kNear_mm = 1;

/// Smallest and largest value of a direction over a grid's outer faces.
struct Extent {
  double low = 0, high = 0;
};
Extent extentAlong(const VolumeGeometry& grid, Vec3 direction) {
  const double middle = dot(grid.center_mm(), direction);
  double half = 0;
  for (int axis = 0; axis < 3; ++axis)
    half += 0.5 * grid.size[axis] * grid.spacing_mm[axis] * std::abs(dot(grid.direction.column[axis], direction));
  return {middle - half, middle + half};
}

std::string sliceWords(SliceKind kind, const VolumeGeometry& grid, const SlicePlane& plane) {
  if (kind == SliceKind::Oblique) return "image plane";
  const char* name = kind == SliceKind::Axial ? "axial" : kind == SliceKind::Coronal ? "coronal" : "sagittal";
  const Extent extent = extentAlong(grid, plane.axes.normal);
  const double step_mm = sliceStep_mm(grid, plane.axes.normal);
  const int count = std::max(1, static_cast<int>(std::lround((extent.high - extent.low) / step_mm)));
  const int number = static_cast<int>(std::floor((dot(plane.center_mm, plane.axes.normal) - extent.low) / step_mm)) + 1;
  char words[64];
  std::snprintf(words, sizeof words, "%s  %d / %d", name, std::clamp(number, 1, count), count);
  return words;
}

bool samePlane(const SlicePlane& a, const SlicePlane& b) {
  return a.axes.right == b.axes.right && a.axes.up == b.axes.up && a.center_mm == b.center_mm &&
         a.mm_per_px == b.mm_per_px && a.width_px == b.width_px && a.height_px == b.height_px;
}

/// Tells whether the slice shows voxels of a block.
bool meets(const SlicePlane& plane, const VolumeGeometry& grid, const VoxelBox& box) {
  if (box.empty()) return false;
  const VolumeGeometry block = gridOf(grid, box);
  const Extent extent = extentAlong(block, plane.axes.normal);
  const double here_mm = dot(plane.center_mm, plane.axes.normal);
  return here_mm >= extent.low && here_mm <= extent.high;
}

}  // namespace

MprView::MprView(SliceKind kind) : kind_(kind), drawing_(std::make_unique<Drawing>(*renderer())) {
  for (const LabelInfo& info : labelTable()) {
    colors_[info.label] = {info.color[0], info.color[1], info.color[2]};
    visible_[info.label] = info.label != kBackground;
  }
  shares_.fill(1);
}

MprView::~MprView() = default;

void MprView::setCase(std::shared_ptr<const VtkCase> patient) {
  patient_ = std::move(patient);
  if (patient_) crosshair_mm_ = patient_->patient().ct.geometry.center_mm();
  drawing_->paintStale = true;
  fit();
}

void MprView::setKind(SliceKind kind) {
  kind_ = kind;
  fit();
}

void MprView::setProbePose(const Transform& patientFromProbe) {
  patientFromProbe_ = patientFromProbe;
  if (kind_ == SliceKind::Oblique) changed();
}

void MprView::setFan(std::optional<Probe> probe, const ImagingSettings& settings) {
  fanProbe_ = std::move(probe);
  fanSettings_ = settings;
  drawing_->fan = fanProbe_ ? fieldOfViewOutline(*fanProbe_, fanSettings_) : std::vector<PlanePoint>{};
  if (picture_) drawing_->paintStale = true;  // the mask has changed
  changed();
}

void MprView::setAlignedImage(std::optional<ImageBounds> bounds) {
  picture_ = bounds;
  drawing_->paintStale = true;
  changed();
}

void MprView::setPointer(std::optional<Vec3> position_mm) {
  if (position_mm == pointer_mm_) return;
  pointer_mm_ = position_mm;
  changed();
}

void MprView::setMarks(std::vector<Vec3> positions_mm) {
  if (positions_mm == marks_mm_) return;
  marks_mm_ = std::move(positions_mm);
  changed();
}

bool MprView::showsMark(Vec3 position_mm) const {
  constexpr double kReach_mm = 3;
  const SlicePlane now = plane();
  return std::abs(dot(position_mm - now.center_mm, now.axes.normal)) <= kReach_mm;
}

void MprView::setCalipers(std::vector<SliceCaliper> calipers) {
  calipers_ = std::move(calipers);
  changed();
}

void MprView::setCrosshair(Vec3 position_mm) {
  if (position_mm == crosshair_mm_ || !isFinite(position_mm)) return;
  crosshair_mm_ = position_mm;
  changed();
}

void MprView::setCrosshairVisible(bool visible) {
  crosshairVisible_ = visible;
  changed();
}

void MprView::setWindowLevel(WindowLevel value) {
  value.window_HU = std::clamp(value.window_HU, 1.0, 10000.0);
  value.level_HU = std::clamp(value.level_HU, -5000.0, 10000.0);
  windowLevel_ = value;
  drawing_->paintStale = true;
  changed();
}

void MprView::setLabelColor(std::uint8_t label, Color color) {
  colors_[label] = color;
  drawing_->paintStale = true;
  changed();
}

void MprView::setLabelVisible(std::uint8_t label, bool visible) {
  visible_[label] = visible;
  drawing_->paintStale = true;
  changed();
}

void MprView::setLabelsVisible(bool visible) {
  labelsVisible_ = visible;
  drawing_->paintStale = true;
  changed();
}

void MprView::setLabelStyle(const LabelStyle& style) {
  labelStyle_ = style;
  drawing_->paintStale = true;
  changed();
}

void MprView::setRelativeLabelOpacity(std::uint8_t label, double share) {
  shares_[label] = std::clamp(share, 0.0, 1.0);
  drawing_->paintStale = true;
  changed();
}

void MprView::setProposal(const VoxelBox& box, std::shared_ptr<const LabelMap> labels) {
  proposalBox_ = box;
  proposal_ = std::move(labels);
  drawing_->paintStale = true;
  changed();
}

void MprView::setToolMarks(SliceMarks marks) {
  toolMarks_ = std::move(marks);
  changed();
}

void MprView::setNamedPoints(std::vector<NamedPoint> places) {
  places_ = std::move(places);
  changed();
}

void MprView::setLabelOpacity(double opacity) {
  labelOpacity_ = std::clamp(opacity, 0.0, 1.0);
  drawing_->paintStale = true;
  changed();
}

void MprView::fitTo(SlicePlane& plane) const {
  const double margin_px = 8 * scale();
  const double room_x = std::max(16.0, width_px() - 2 * margin_px),
               room_y = std::max(16.0, height_px() - 2 * margin_px);
  if (asPicture()) {
    const ImagePlacement place = placementOf(*picture_, width_px(), height_px(), scale());
    plane.mm_per_px = 1 / place.px_per_mm;
    plane.center_mm =
        patientFromProbe_ * Vec3{picture_->minLateral_mm + (0.5 * width_px() - place.left_px) * plane.mm_per_px, 0,
                                 picture_->minAxial_mm + (0.5 * height_px() - place.top_px) * plane.mm_per_px};
    return;
  }
  if (overFan()) {
    const BeamGrid grid(*fanProbe_, fanSettings_);
    const double wide_mm = grid.maxLateral_mm() - grid.minLateral_mm(),
                 deep_mm = grid.maxAxial_mm() - grid.minAxial_mm();
    plane.center_mm = patientFromProbe_ * Vec3{0, 0, 0.5 * (grid.minAxial_mm() + grid.maxAxial_mm())};
    // Shows some of the surroundings of the field of view, for orientation in the patient.
    plane.mm_per_px = 1.35 * std::max(wide_mm / room_x, deep_mm / room_y);
    return;
  }
  const VolumeGeometry& volume = patient_->patient().ct.geometry;
  const Extent across = extentAlong(volume, plane.axes.right), along = extentAlong(volume, plane.axes.up);
  plane.center_mm = volume.center_mm();
  plane.mm_per_px = std::max((across.high - across.low) / room_x, (along.high - along.low) / room_y);
}

SlicePlane MprView::plane() const {
  // Keeps the visible extent when the view is maximized and restored.
  const double zoom = fitted_ ? 1 : double(zoomedIn_px_) / std::min(width_px(), height_px());
  SlicePlane plane{sliceAxes(kind_, patientFromProbe_), middle_mm_, mm_per_px_ * zoom, width_px(), height_px()};
  if ((fitted_ || asPicture()) && (patient_ || overFan())) fitTo(plane);
  const Vec3 through_mm = kind_ == SliceKind::Oblique ? patientFromProbe_.offset : crosshair_mm_;
  plane.center_mm = plane.center_mm + plane.axes.normal * dot(through_mm - plane.center_mm, plane.axes.normal);
  return plane;
}

void MprView::stopFitting() {
  const SlicePlane now = plane();
  middle_mm_ = now.center_mm, mm_per_px_ = now.mm_per_px, zoomedIn_px_ = std::min(width_px(), height_px());
  fitted_ = false;
}

void MprView::fit() {
  fitted_ = true;
  changed();
}

void MprView::zoom(double factor) {
  stopFitting();
  mm_per_px_ = std::clamp(mm_per_px_ / factor, 0.005, 10.0);
  changed();
}

void MprView::stepSlices(int slices) {
  if (!patient_ || kind_ == SliceKind::Oblique) return;
  const VolumeGeometry& volume = patient_->patient().ct.geometry;
  const Vec3 normal = plane().axes.normal;
  const double step_mm = sliceStep_mm(volume, normal);
  const Extent extent = extentAlong(volume, normal);
  const int count = std::max(1, static_cast<int>(std::lround((extent.high - extent.low) / step_mm)));
  const double here_mm = dot(crosshair_mm_, normal);
  const int index = static_cast<int>(std::floor((here_mm - extent.low) / step_mm)) + slices;
  const double there_mm = extent.low + (std::clamp(index, 0, count - 1) + 0.5) * step_mm;
  moveCrosshair(crosshair_mm_ + normal * (there_mm - here_mm));
}

void MprView::paintLabels() {
  drawing_->sampler.setWindowLevel(windowLevel_);
  drawing_->sampler.setOutlineWidth(std::max(1, int(std::lround(labelStyle_.thickness_px * scale()))));
  for (int label = 0; label < 256; ++label) {
    const double share = labelsVisible_ && visible_[label] ? shares_[std::size_t(label)] : 0;
    const double fill = labelStyle_.fill ? share * labelOpacity_ : 0;
    const double alone = labelStyle_.fill ? std::min(1.0, 2 * fill) : share * kOutlineAlone;
    drawing_->sampler.setPaint(static_cast<std::uint8_t>(label),
                               {colors_[label], fill, labelStyle_.outline ? alone : 0});
  }
}

bool MprView::isStale() const {
  return patient_ && drawing_->sampledLabels != patient_->labelRevision();
}

bool MprView::passesThrough(Vec3 point_mm, const SlicePlane& plane) const {
  return std::abs(plane.distance_mm(point_mm)) < kNear_mm;
}

std::vector<DisplayPoint> MprView::fanOn(const SlicePlane& plane) const {
  std::vector<DisplayPoint> fan;
  if (overFan())
    for (const PlanePoint& point : drawing_->fan)
      fan.push_back(plane.displayFromPatient(patientFromProbe_ * Vec3{point.lateral_mm, 0, point.axial_mm}));
  return fan;
}

void MprView::sample(const SlicePlane& plane, int firstRow, int endRow) {
  const auto rgb = drawing_->quad.picture(plane.width_px, plane.height_px);
  drawing_->sampler.setProposal(proposalBox_, proposal_.get());
  drawing_->sampler.sample(patient_->patient().ct, patient_->labels(), plane, {firstRow, endRow}, rgb);
  if (asPicture()) drawing_->mask.apply(fanOn(plane), plane.width_px, plane.height_px, rgb);
  drawing_->quad.pictureChanged();
  drawing_->quad.place({0, 0}, {double(plane.width_px), double(plane.height_px)}, plane.height_px, {});
  drawing_->sampled = plane, drawing_->paintStale = false;
}

void MprView::layout() {
  drawing_->quad.show(patient_ != nullptr);
  if (!patient_) {
    drawing_->lines.begin(height_px()), drawing_->lines.end();
    drawing_->texts.begin(height_px()), drawing_->texts.end();
    return;
  }
  const SlicePlane now = plane();
  const VoxelBox edited = patient_->changedSince(drawing_->sampledLabels);
  const VolumeGeometry& grid = patient_->patient().ct.geometry;
  if (drawing_->paintStale) paintLabels();
  if (drawing_->paintStale || !samePlane(now, drawing_->sampled)) {
    sample(now, 0, now.height_px);
  } else if (meets(now, grid, edited)) {
    const auto [first, end] = drawing_->sampler.rowsOf(grid, edited, now);
    sample(now, first, end);
  }
  drawing_->sampledLabels = patient_->labelRevision();
  MprOverlay overlay;
  overlay.kind = kind_, overlay.windowLevel = windowLevel_;
  overlay.slice = asPicture() ? "CT" : sliceWords(kind_, patient_->patient().ct.geometry, now);
  // On a slice that does not pass through the crosshair, it would mark another place.
  if (crosshairVisible_ && passesThrough(crosshair_mm_, now)) overlay.crosshair_mm = crosshair_mm_;
  if (pointer_mm_ && passesThrough(*pointer_mm_, now)) overlay.pointer_mm = pointer_mm_;
  for (std::size_t k = 0; k < calipers_.size(); ++k)
    if (std::ranges::all_of(calipers_[k].points_mm, [&](Vec3 point_mm) { return passesThrough(point_mm, now); }))
      overlay.calipers.emplace_back(int(k) + 1, onSlice(calipers_[k], now.axes));
  overlay.toolMarks = &toolMarks_;
  for (const NamedPoint& place : places_)
    if (showsMark(place.position_mm)) overlay.places.push_back(&place);
  overlay.fan = fanOn(now);
  for (std::size_t k = 0; k < marks_mm_.size(); ++k)
    if (showsMark(marks_mm_[k])) overlay.marks_mm.emplace_back(int(k) + 1, marks_mm_[k]);
  drawMprOverlay(overlay, now, scale(), drawing_->lines, drawing_->texts);
}

}  // namespace insonate::views
