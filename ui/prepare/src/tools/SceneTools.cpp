#include "SceneTools.h"

#include "../layout/CaseViews.h"
#include "ToolSession.h"

#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/ViewWidget.h>

#include <QMouseEvent>

namespace insonate::prepare {
namespace {

/// A freehand line has a corner every few pixels.
constexpr double kCorner_px = 3;

}  // namespace

SceneTools::SceneTools(CaseViews& views, ToolSession& tools) : QObject(&views), views_(views), tools_(tools) {
  ui::CanvasInput::of(*views_.widgets()[CaseViews::kSlices]->focusProxy()).add(ui::InputRank::Tool, *this);
  connect(&tools_, &ToolSession::pointsChanged, this, [this] { showLine(); });
}

bool SceneTools::eventFilter(QObject*, QEvent* event) {
  if (!tools_.cutsScene()) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      return pressed(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseMove:
      return moved(*static_cast<QMouseEvent*>(event));
    case QEvent::MouseButtonRelease:
      return released(*static_cast<QMouseEvent*>(event));
    default:
      return false;
  }
}

bool SceneTools::pressed(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || event.modifiers() & (Qt::ControlModifier | Qt::ShiftModifier)) return false;
  views_.widgets()[CaseViews::kSlices]->focusProxy()->setFocus(Qt::MouseFocusReason);
  held_ = true;
  addCorner(event.localPos());
  return true;
}

bool SceneTools::moved(const QMouseEvent& event) {
  if (!held_) return false;
  const QPointF way = event.localPos() - last_;
  if (way.manhattanLength() > kCorner_px) addCorner(event.localPos());
  return true;
}

bool SceneTools::released(const QMouseEvent& event) {
  if (!held_ || event.button() != Qt::LeftButton) return false;
  held_ = false;
  tools_.preview();
  return true;
}

void SceneTools::addCorner(QPointF at) {
  last_ = at;
  views::SceneView& scene = *views_.sharedScene();
  const double ratio = views_.widgets()[CaseViews::kSlices]->devicePixelRatioF();
  const views::DisplayPoint place{(at.x() + 0.5) * ratio, (at.y() + 0.5) * ratio};
  ScissorsView look{.along = -scene.viewerDirection(), .eye_mm = scene.eye_mm()};
  if (const auto seen = scene.pick(place)) look.surface_mm = seen->position_mm;
  tools_.addScenePoint(scene.pointInFrontOf(place), look);
}

void SceneTools::showLine() {
  std::vector<Vec3> line_mm;
  if (tools_.isDrawnInScene()) line_mm = tools_.points();
  if (!line_mm.empty()) line_mm.push_back(line_mm.front());
  views_.setSceneLine(std::move(line_mm));
}

}  // namespace insonate::prepare
