#include "ToolSession.h"

#include "../labels/LabelSession.h"
#include "../model/Notice.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "../model/StructureList.h"
#include "../model/TermsEditor.h"

#include <insonate/tissue/Labels.h>
#include <insonate/views/SlicePlane.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::prepare {
namespace {

/// Limits of lengths, relative to a voxel and to the CT's longest side.
constexpr double kMinOfVoxel = 0.5, kMaxOfSide = 0.2;
/// Radius around the clicked voxel.
constexpr int kAround_HU = 60;

double ml(std::size_t voxels, Vec3 spacing_mm) {
  return double(voxels) * spacing_mm.x * spacing_mm.y * spacing_mm.z / 1000;
}

}  // namespace

ToolSession::ToolSession(PrepareModel& shared, QObject* parent) : QObject(parent), shared_(shared) {
  connect(&shared_.openCase, &OpenCase::caseChanged, this, [this] { choose({}); });
  connect(&shared_.structures, &StructureList::selectedChanged, this, [this] { changed(); });
  connect(&shared_.labeling, &LabelSession::busyChanged, this, &ToolSession::pointsChanged);
  connect(&shared_.labeling, &LabelSession::failed, this, &ToolSession::messageReported);
  // The preview must equal the result of Enter.
  connect(&shared_.labeling, &LabelSession::rulesChanged, this, [this] { changed(); });
}

void ToolSession::choose(const QString& id) {
  const auto& table = toolTable();
  const auto found = std::ranges::find(table, id, &Tool::id);
  const Tool* const next = found == table.end() ? nullptr : &*found;
  if (next == tool_) return;
  shared_.labeling.endStroke();
  shared_.labeling.preview().clear();
  if (tool_) {
    last_ = tool_->id;
    if (auto* points = pointsOf(parameters_)) points->clear();
    kept_[tool_->id] = parameters_;
  }
  sceneLook_.reset();
  tool_ = next;
  if (tool_) {
    shared_.labeling.getReady();
    const auto kept = kept_.find(id);
    parameters_ = kept == kept_.end() ? tool_->usual : kept->second;
    for (const ToolNumber& number : tool_->numbers)
      if (const ui::ValueRange range = rangeOf(number); number.ofVoxels || number.fromAVoxel)
        number.set(parameters_, std::clamp(number.get(parameters_), range.minimum, range.maximum));
  }
  Q_EMIT toolChanged();
  Q_EMIT pointsChanged();
  changed();
}

void ToolSession::chooseLast() {
  choose(last_);
}

void ToolSession::changed() {
  if (!tool_) return;
  Q_EMIT messageReported({});
  // The preview must equal the result of Enter. A click asks for a preview.
  const bool clicked = tool_->input == ToolInput::Range || tool_->input == ToolInput::Points;
  if (isComplete() && (clicked || isPreviewRequested()))
    preview();
  else
    shared_.labeling.preview().clear();
}

bool ToolSession::isPreviewRequested() const {
  const LabelPreview& preview = shared_.labeling.preview();
  return preview.proposal() || preview.isComputing();
}

void ToolSession::setNumber(const ToolNumber& number, double value) {
  number.set(parameters_, value);
  Q_EMIT parametersChanged();
  changed();
}

void ToolSession::setChoice(const ToolChoice& choice, int index) {
  choice.set(parameters_, index);
  Q_EMIT parametersChanged();
  changed();
}

void ToolSession::setRange(HuRange range) {
  if (!tool_ || !tool_->range) return;
  tool_->range->set(parameters_, range);
  Q_EMIT parametersChanged();
  changed();
}

void ToolSession::setOther(std::uint8_t label) {
  if (!tool_ || !tool_->other) return;
  tool_->other->set(parameters_, label);
  Q_EMIT parametersChanged();
  changed();
}

ui::ValueRange ToolSession::rangeOf(const ToolNumber& number) const {
  ui::ValueRange range = number.range;
  if (!shared_.openCase.patient()) return range;
  const VolumeGeometry& grid = shared_.openCase.patient()->ct.geometry;
  const Vec3& voxel_mm = grid.spacing_mm;
  const double finest_mm = std::min({voxel_mm.x, voxel_mm.y, voxel_mm.z});
  if (number.fromAVoxel) {
    range.minimum = std::clamp(std::ceil(10 * finest_mm) / 10, range.minimum, range.maximum);
    range.defaultValue = std::max(range.defaultValue, range.minimum);
  }
  if (!number.ofVoxels) return range;
  double longest_mm = 0;
  for (int axis = 0; axis < 3; ++axis) longest_mm = std::max(longest_mm, grid.size[axis] * voxel_mm[axis]);
  // Rounds to one digit, as displayed.
  const auto tenths = [](double mm) { return std::max(0.1, std::round(10 * mm) / 10); };
  range.minimum = tenths(kMinOfVoxel * finest_mm);
  range.maximum = std::max(tenths(kMaxOfSide * longest_mm), range.minimum + 1);
  range.defaultValue = std::clamp(range.defaultValue, range.minimum, range.maximum);
  return range;
}

const std::vector<Vec3>& ToolSession::points() const {
  static const std::vector<Vec3> kNone;
  const auto* points = tool_ ? pointsOf(const_cast<LabelTool&>(parameters_)) : nullptr;
  return points ? *points : kNone;
}

void ToolSession::addPoint(Vec3 patient_mm, views::SliceKind slice) {
  auto* points = tool_ ? pointsOf(parameters_) : nullptr;
  if (!points || !isFinite(patient_mm)) return;
  slice_ = slice;
  if (std::exchange(sceneLook_, std::nullopt)) points->clear();
  // This tool takes one point.
  if (std::holds_alternative<step::KeepIsland>(parameters_)) points->clear();
  points->push_back(patient_mm);
  Q_EMIT pointsChanged();
  changed();
}

bool ToolSession::cutsScene() const {
  return tool_ && std::holds_alternative<step::Scissors>(parameters_);
}

void ToolSession::addScenePoint(Vec3 patient_mm, const ScissorsView& look) {
  if (!cutsScene() || !isFinite(patient_mm)) return;
  auto& points = *pointsOf(parameters_);
  // The drawing has another meaning from another view, or on a slice.
  if (!sceneLook_ || sceneLook_->eye_mm != look.eye_mm) points.clear();
  if (points.empty()) sceneLook_ = look;
  if (!sceneLook_->surface_mm) sceneLook_->surface_mm = look.surface_mm;
  points.push_back(patient_mm);
  Q_EMIT pointsChanged();
  changed();
}

void ToolSession::clearPoints() {
  auto* points = tool_ ? pointsOf(parameters_) : nullptr;
  if (!points) return;
  points->clear();
  Q_EMIT pointsChanged();
  changed();
}

void ToolSession::removeNearest(Vec3 patient_mm) {
  auto* points = tool_ ? pointsOf(parameters_) : nullptr;
  if (!points || points->empty()) return;
  points->erase(std::ranges::min_element(*points, {}, [&](Vec3 p) { return norm(p - patient_mm); }));
  Q_EMIT pointsChanged();
  changed();
}

void ToolSession::takeRange(Vec3 patient_mm) {
  auto* threshold = std::get_if<step::Threshold>(&parameters_);
  if (!tool_ || !threshold || !shared_.openCase.patient()) return;
  const CtVolume& ct = shared_.openCase.patient()->ct;
  const int hu = int(std::lround(sampleLinear(ct, ct.geometry.indexFromPatient() * patient_mm)));
  threshold->range_HU = {hu - kAround_HU, hu + kAround_HU};
  Q_EMIT parametersChanged();
  changed();
}

int ToolSession::axisOf(views::SliceKind slice) const {
  const Vec3 normal = views::sliceAxes(slice).normal;
  const auto& axes = shared_.openCase.patient()->ct.geometry.direction.column;
  int best = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(dot(axes[axis], normal)) > std::abs(dot(axes[best], normal))) best = axis;
  return best;
}

void ToolSession::fillIn(LabelTool& tool) const {
  std::vector<std::uint8_t> structures, filling;
  for (const std::uint8_t label : shared_.structures.labels()) {
    const bool fills = std::ranges::find(kFilling, label) != std::end(kFilling);
    if (shared_.labeling.rules().mayEdit(label)) (fills ? filling : structures).push_back(label);
  }
  if (auto* s = std::get_if<step::Paint>(&tool); s && s->sliceAxis) s->sliceAxis = axisOf(slice_);
  if (auto* s = std::get_if<step::Draw>(&tool)) s->sliceAxis = axisOf(slice_);
  if (auto* s = std::get_if<step::FillBetween>(&tool)) s->sliceAxis = axisOf(slice_);
  if (auto* s = std::get_if<step::CutOff>(&tool)) s->stroke.along = views::sliceAxes(slice_).normal;
  if (auto* s = std::get_if<step::Scissors>(&tool)) {
    s->view.along = sceneLook_ ? sceneLook_->along : views::sliceAxes(slice_).normal;
    s->view.eye_mm = sceneLook_ ? sceneLook_->eye_mm : std::nullopt;
    s->view.surface_mm = sceneLook_ ? sceneLook_->surface_mm : std::nullopt;
  }
  if (auto* s = std::get_if<step::GrowSeeds>(&tool)) s->seeds = structures, s->over = filling;
  if (auto* s = std::get_if<step::Watershed>(&tool)) s->seeds = structures, s->over = filling;
  if (auto* s = std::get_if<step::SmoothTogether>(&tool)) {
    s->labels = structures;
    s->labels.insert(s->labels.end(), filling.begin(), filling.end());
  }
}

LabelStep ToolSession::step() const {
  LabelStep step;
  step.rest = LabelStep::kSurroundings;
  step.tool = parameters_;
  fillIn(step.tool);
  step.label = shared_.structures.selected();
  if (tool_->erases) {
    step.over = std::vector<std::uint8_t>{step.label};
    step.label = step.rest;
  }
  return step;
}

bool ToolSession::beginStroke(Vec3 patient_mm, views::SliceKind slice) {
  if (!tool_ || tool_->input != ToolInput::Brush) return false;
  if (shared_.structures.selected() == kBackground) {
    shared_.notice.showMessage(tr("Choose a label in the table on the left first, or add one there."));
    return false;
  }
  slice_ = slice;
  if (!shared_.labeling.beginStroke(step(),
                                    tr("%1 %2").arg(tool_->name, shared_.terms.nameOf(shared_.structures.selected()))))
    return false;
  strokeTo(patient_mm);
  return true;
}

void ToolSession::strokeTo(Vec3 patient_mm) {
  shared_.labeling.strokeTo(patient_mm);
}

void ToolSession::endStroke() {
  shared_.labeling.endStroke();
}

double ToolSession::brushRadius_mm() const {
  const auto* brush = tool_ ? std::get_if<step::Paint>(&parameters_) : nullptr;
  return brush ? brush->radius_mm : 0;
}

bool ToolSession::brushIsFlat() const {
  const auto* brush = tool_ ? std::get_if<step::Paint>(&parameters_) : nullptr;
  return brush && brush->sliceAxis;
}

void ToolSession::scaleBrush(double factor) {
  if (!tool_ || tool_->input != ToolInput::Brush) return;
  const ToolNumber& radius = tool_->numbers.front();
  const ui::ValueRange range = rangeOf(radius);
  radius.set(parameters_, std::clamp(radius.get(parameters_) * factor, range.minimum, range.maximum));
  Q_EMIT parametersChanged();
}

bool ToolSession::isComplete() const {
  const bool lacksOther = tool_ && tool_->other && tool_->other->get(parameters_) == kBackground;
  return tool_ && !lacksOther && tool_->input != ToolInput::Brush && shared_.structures.selected() != kBackground &&
         !shared_.labeling.isBusy() && int(points().size()) >= tool_->minPoints;
}

void ToolSession::preview() {
  if (isComplete()) shared_.labeling.wantPreview(step());
}

void ToolSession::apply() {
  if (!isComplete()) return;
  Q_EMIT messageReported({});
  const QString what = tr("%1 %2").arg(tool_->name, shared_.terms.nameOf(shared_.structures.selected()));
  shared_.labeling.run(step(), what, [this, what](const Result<LabelChange>& change) {
    if (!change && change.error().message == kCancelled)
      return shared_.notice.showMessage(tr("%1: stopped; no label was changed.").arg(what));
    if (!change) return;
    if (auto* points = pointsOf(parameters_)) points->clear();
    Q_EMIT pointsChanged();
    if (change->voxels == 0)
      return Q_EMIT messageReported(
          tr("No voxel changed: all voxels already had the label or may not be overwritten."));
    const QString volume = volumeText(ml(change->voxels, shared_.openCase.patient()->ct.geometry.spacing_mm));
    shared_.notice.showMessage(tr("%1: %2 ml changed; Ctrl+Z undoes it.").arg(what, volume));
  });
}

void ToolSession::leave() {
  if (shared_.labeling.isBusy()) return shared_.labeling.cancel();
  auto* points = tool_ ? pointsOf(parameters_) : nullptr;
  if ((points && !points->empty()) || isPreviewRequested()) {
    if (points) points->clear();
    shared_.labeling.preview().clear();
    Q_EMIT pointsChanged();
    return;
  }
  choose({});
}

}  // namespace insonate::prepare
