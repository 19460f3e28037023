#include "SliceTools.h"

#include "../labels/LabelSession.h"
#include "../layout/CaseViews.h"
#include "../model/Crosshair.h"
#include "../model/OpenCase.h"
#include "../model/PrepareModel.h"
#include "../model/StatusLine.h"

#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/Commands.h>
#include <insonate/ui/ViewWidget.h>

#include <QMouseEvent>
#include <QWheelEvent>

namespace insonate::prepare {
namespace {

bool isPlain(const QMouseEvent& event) {
  return !(event.modifiers() & (Qt::ControlModifier | Qt::ShiftModifier));
}

bool isLine(ToolInput input) {
  return input == ToolInput::Outline || input == ToolInput::Stroke;
}

}  // namespace

SliceTools::SliceTools(CaseViews& views, ToolSession& tools, PrepareModel& shared, const ui::Commands& commands)
    : QObject(&views),
      views_(views),
      tools_(tools),
      shared_(shared),
      commands_(commands),
      preview_(shared.labeling.preview()) {
  for (int slice = 0; slice < CaseViews::kSlices; ++slice)
    ui::CanvasInput::of(*views_.widgets()[std::size_t(slice)]->focusProxy()).add(ui::InputRank::Tool, *this);
  connect(&tools_, &ToolSession::toolChanged, this, [this] { pointAt(tools_.tool() ? pointer_ : std::nullopt); });
  // Another slice is now under the pointer.
  connect(&shared_.crosshair, &Crosshair::moved, this, [this] { pointAt(pointer_); });
  connect(&tools_, &ToolSession::pointsChanged, this, [this] { showMarks(); });
  connect(&tools_, &ToolSession::parametersChanged, this, [this] { showMarks(); });
  connect(&preview_, &LabelPreview::changed, this, [this] { showPreview(); });
}

int SliceTools::sliceOf(const QObject* canvas) const {
  for (int slice = 0; slice < CaseViews::kSlices; ++slice)
    if (views_.widgets()[std::size_t(slice)]->focusProxy() == canvas) return slice;
  return -1;
}

Vec3 SliceTools::placeOf(int slice, QPointF at) const {
  const double ratio = views_.widgets()[std::size_t(slice)]->devicePixelRatioF();
  return views_.slice(slice).patientFromDisplay({(at.x() + 0.5) * ratio, (at.y() + 0.5) * ratio});
}

bool SliceTools::eventFilter(QObject* watched, QEvent* event) {
  const int slice = sliceOf(watched);
  if (slice < 0 || !tools_.tool()) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    // The second press of a double click counts as a press if clicks set points.
    case QEvent::MouseButtonDblClick:
      return pressed(slice, *static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return moved(slice, *static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return released(*static_cast<QMouseEvent*>(event));
    case QEvent::Wheel:
      return wheel(*static_cast<QWheelEvent*>(event));
    case QEvent::Leave:
      pointAt({});
      return false;
    default:
      // The guide uses some of these keys, too.
      return commands_.handleKeyEvent(*event);
  }
}

bool SliceTools::pressed(int slice, const QMouseEvent& event) {
  const ToolInput input = tools_.tool()->input;
  if (input == ToolInput::Nothing || !isPlain(event)) return false;
  views_.widgets()[std::size_t(slice)]->focusProxy()->setFocus(Qt::MouseFocusReason);
  const Vec3 at_mm = placeOf(slice, event.localPos());
  const views::SliceKind kind = views_.slice(slice).kind();
  if (event.button() == Qt::RightButton && !tools_.points().empty()) {
    tools_.removeNearest(at_mm);
    return true;
  }
  if (event.button() != Qt::LeftButton) return false;
  held_ = true;
  if (input == ToolInput::Brush)
    held_ = tools_.beginStroke(at_mm, kind);
  else if (input == ToolInput::Range)
    tools_.takeRange(at_mm);
  else {
    if (input == ToolInput::Stroke) tools_.clearPoints();
    tools_.addPoint(at_mm, kind);
  }
  return true;
}

bool SliceTools::moved(int slice, const QMouseEvent& event) {
  under_ = slice;
  pointAt(event.localPos());
  if (!pointer_mm_) return false;
  const Vec3 at_mm = *pointer_mm_;
  const ToolInput input = tools_.tool()->input;
  if (held_ && input == ToolInput::Brush) tools_.strokeTo(at_mm);
  if (held_ && input == ToolInput::Range) tools_.takeRange(at_mm);
  // A freehand line has a corner every few pixels.
  constexpr double kCorner_px = 3;
  if (held_ && isLine(input) && !tools_.points().empty() &&
      norm(at_mm - tools_.points().back()) > kCorner_px * views_.slice(slice).plane().mm_per_px)
    tools_.addPoint(at_mm, views_.slice(slice).kind());
  return held_;
}

bool SliceTools::released(const QMouseEvent& event) {
  if (!held_ || event.button() != Qt::LeftButton) return false;
  held_ = false;
  tools_.endStroke();
  if (isLine(tools_.tool()->input)) tools_.preview();
  return true;
}

bool SliceTools::wheel(const QWheelEvent& event) {
  if (!(event.modifiers() & Qt::ShiftModifier) || tools_.tool()->input != ToolInput::Brush) return false;
  const QPoint turned = event.angleDelta();
  tools_.scaleBrush(turned.y() + turned.x() > 0 ? ToolSession::kBrushStep : 1 / ToolSession::kBrushStep);
  return true;
}

void SliceTools::pointAt(std::optional<QPointF> at) {
  pointer_ = at;
  pointer_mm_.reset();
  if (at && shared_.openCase.patient()) pointer_mm_ = placeOf(under_, *at);
  shared_.statusLine.pointAt(pointer_mm_);
  showMarks();
}

void SliceTools::showMarks() {
  const Tool* const tool = tools_.tool();
  for (int slice = 0; slice < CaseViews::kSlices; ++slice) {
    views::SliceMarks marks;
    const auto& points = tools_.points();
    if (tool && isLine(tool->input)) {
      if (!tools_.isDrawnInScene()) marks.line_mm = points;
      if (!marks.line_mm.empty() && tool->input == ToolInput::Outline) marks.line_mm.push_back(points.front());
    } else {
      marks.points_mm = points;
    }
    const bool flat = tools_.brushIsFlat();
    if (tool && tool->input == ToolInput::Brush && pointer_mm_ && (!flat || slice == under_))
      marks.brush = {*pointer_mm_, tools_.brushRadius_mm(), flat};
    views_.slice(slice).setToolMarks(std::move(marks));
  }
}

void SliceTools::showPreview() {
  const auto& proposal = preview_.proposal();
  for (int slice = 0; slice < CaseViews::kSlices; ++slice)
    views_.slice(slice).setProposal(proposal ? proposal->box : VoxelBox{},
                                    proposal ? std::shared_ptr<const LabelMap>(proposal, &proposal->labels) : nullptr);
}

}  // namespace insonate::prepare
