#include "ToolSession.h"

#include "../PrepareSession.h"

#include <insonate/tissue/Labels.h>
#include <insonate/views/SlicePlane.h>

#include <algorithm>
#include <cmath>

namespace insonate::prepare {
namespace {

constexpr double kLeastRadius_mm = 0.3, kMostRadius_mm = 40;
/// Around the voxel that was clicked.
constexpr int kAround_HU = 60;

}  // namespace

ToolSession::ToolSession(PrepareSession& session, QObject* parent) : QObject(parent), session_(session) {
  connect(&session_, &PrepareSession::caseChanged, this, [this] { choose({}); });
  connect(&session_, &PrepareSession::selectedChanged, this, [this] { changed(); });
  connect(&session_.labelling(), &LabelSession::busyChanged, this, &ToolSession::pointsChanged);
}

void ToolSession::choose(const QString& id) {
  const auto& table = toolTable();
  const auto found = std::ranges::find(table, id, &Tool::id);
  const Tool* const next = found == table.end() ? nullptr : &*found;
  if (next == tool_) return;
  session_.labelling().endStroke();
  session_.labelling().preview().clear();
  if (tool_) {
    last_ = tool_->id;
    if (auto* points = pointsOf(parameters_)) points->clear();
    kept_[tool_->id] = parameters_;
  }
  tool_ = next;
  if (tool_) {
    const auto kept = kept_.find(id);
    parameters_ = kept == kept_.end() ? tool_->usual : kept->second;
  }
  Q_EMIT toolChanged();
  Q_EMIT pointsChanged();
}

void ToolSession::chooseLast() {
  choose(last_);
}

void ToolSession::changed() {
  if (!tool_) return;
  // What is shown must be what Enter would write.
  const bool shown = session_.labelling().preview().proposal() || session_.labelling().preview().isComputing();
  if (isComplete() && (shown || tool_->input == ToolInput::Range))
    preview();
  else
    session_.labelling().preview().clear();
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

const std::vector<Vec3>& ToolSession::points() const {
  static const std::vector<Vec3> kNone;
  const auto* points = tool_ ? pointsOf(const_cast<LabelTool&>(parameters_)) : nullptr;
  return points ? *points : kNone;
}

void ToolSession::addPoint(Vec3 patient_mm, views::SliceKind slice) {
  auto* points = tool_ ? pointsOf(parameters_) : nullptr;
  if (!points || !isFinite(patient_mm)) return;
  slice_ = slice;
  // An island is one.
  if (std::holds_alternative<step::KeepIsland>(parameters_)) points->clear();
  points->push_back(patient_mm);
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
  if (!tool_ || !threshold || !session_.patient()) return;
  const CtVolume& ct = session_.patient()->ct;
  const int hu = int(std::lround(sampleLinear(ct, ct.geometry.indexFromPatient() * patient_mm)));
  threshold->range_HU = {hu - kAround_HU, hu + kAround_HU};
  Q_EMIT parametersChanged();
  changed();
}

int ToolSession::axisOf(views::SliceKind slice) const {
  const Vec3 normal = views::sliceAxes(slice).normal;
  const auto& axes = session_.patient()->ct.geometry.direction.column;
  int best = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(dot(axes[axis], normal)) > std::abs(dot(axes[best], normal))) best = axis;
  return best;
}

void ToolSession::fillIn(LabelTool& tool) const {
  std::vector<std::uint8_t> structures, filling;
  for (const std::uint8_t label : session_.structures()) {
    const bool fills = std::ranges::find(kFilling, label) != std::end(kFilling);
    if (session_.labelling().rules().mayEdit(label)) (fills ? filling : structures).push_back(label);
  }
  if (auto* s = std::get_if<step::Paint>(&tool); s && s->sliceAxis) s->sliceAxis = axisOf(slice_);
  if (auto* s = std::get_if<step::Draw>(&tool)) s->sliceAxis = axisOf(slice_);
  if (auto* s = std::get_if<step::FillBetween>(&tool)) s->sliceAxis = axisOf(slice_);
  if (auto* s = std::get_if<step::Scissors>(&tool)) s->view.along = views::sliceAxes(slice_).normal;
  if (auto* s = std::get_if<step::GrowSeeds>(&tool)) s->seeds = structures, s->over = filling;
  if (auto* s = std::get_if<step::Watershed>(&tool)) s->seeds = structures, s->over = filling;
  if (auto* s = std::get_if<step::SmoothTogether>(&tool)) {
    s->labels = structures;
    s->labels.insert(s->labels.end(), filling.begin(), filling.end());
  }
}

LabelStep ToolSession::step() const {
  LabelStep step;
  step.tool = parameters_;
  fillIn(step.tool);
  step.label = session_.selected();
  if (tool_->erases) {
    step.over = std::vector<std::uint8_t>{step.label};
    step.label = step.rest;
  }
  return step;
}

bool ToolSession::beginStroke(Vec3 patient_mm, views::SliceKind slice) {
  if (!tool_ || tool_->input != ToolInput::Brush) return false;
  if (session_.selected() == kBackground) {
    session_.say(tr("Choose a label in the table on the left first, or add one there."));
    return false;
  }
  slice_ = slice;
  if (!session_.labelling().beginStroke(step(), tr("%1 %2").arg(tool_->name, structureName(session_.selected()))))
    return false;
  strokeTo(patient_mm);
  return true;
}

void ToolSession::strokeTo(Vec3 patient_mm) {
  session_.labelling().strokeTo(patient_mm);
}

void ToolSession::endStroke() {
  session_.labelling().endStroke();
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
  auto* brush = tool_ ? std::get_if<step::Paint>(&parameters_) : nullptr;
  if (!brush) return;
  brush->radius_mm = std::clamp(brush->radius_mm * factor, kLeastRadius_mm, kMostRadius_mm);
  Q_EMIT parametersChanged();
}

bool ToolSession::isComplete() const {
  return tool_ && tool_->input != ToolInput::Brush && session_.selected() != kBackground &&
         !session_.labelling().isBusy() && int(points().size()) >= tool_->leastPoints;
}

void ToolSession::preview() {
  if (isComplete()) session_.labelling().wantPreview(step());
}

void ToolSession::apply() {
  if (!isComplete()) return;
  session_.labelling().run(
      step(), tr("%1 %2").arg(tool_->name, structureName(session_.selected())),
      [this](const Result<LabelChange>& change) {
        if (!change) return;
        if (auto* points = pointsOf(parameters_)) points->clear();
        Q_EMIT pointsChanged();
        session_.say(change->voxels > 0 ? tr("Done; Ctrl+Z takes it back.") : tr("Nothing had to be changed."));
      });
}

void ToolSession::leave() {
  if (session_.labelling().isBusy()) return session_.labelling().cancel();
  auto* points = tool_ ? pointsOf(parameters_) : nullptr;
  const bool shown = session_.labelling().preview().proposal() != nullptr;
  if ((points && !points->empty()) || shown) {
    if (points) points->clear();
    session_.labelling().preview().clear();
    Q_EMIT pointsChanged();
    return;
  }
  choose({});
}

}  // namespace insonate::prepare
