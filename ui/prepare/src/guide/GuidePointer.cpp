#include "GuidePointer.h"

#include "../labels/LabelSession.h"
#include "../model/PrepareModel.h"
#include "../model/TermsEditor.h"
#include "GuideSession.h"

#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/views/MprView.h>

#include <QApplication>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::prepare {
namespace {

constexpr double kNear_px = 9;  // distance from a point, in logical pixels

}  // namespace

GuidePointer::GuidePointer(GuideSession& guide, PrepareModel& shared, QObject* parent)
    : QObject(parent), guide_(guide), shared_(shared) {
  addKeys();
}

void GuidePointer::watch(ui::ViewWidget& widget, views::MprView& slice) {
  watched_.push_back({&widget, &slice});
  ui::CanvasInput::of(*widget.focusProxy()).add(ui::InputRank::Guide, *this);
}

Vec3 GuidePointer::patientAt(const Watched& where, QPoint at) const {
  const double ratio = where.widget->devicePixelRatioF();
  return where.slice->patientFromDisplay({(at.x() + 0.5) * ratio, (at.y() + 0.5) * ratio});
}

std::optional<std::size_t> GuidePointer::clickAt(const Watched& where, QPoint at) const {
  const double ratio = where.widget->devicePixelRatioF();
  for (std::size_t n = 0; n < guide_.clicks_mm().size(); ++n) {
    if (!where.slice->showsMark(guide_.clicks_mm()[n])) continue;
    const views::DisplayPoint p = where.slice->displayFromPatient(guide_.clicks_mm()[n]);
    if (std::hypot(p.x / ratio - at.x(), p.y / ratio - at.y()) <= kNear_px) return n;
  }
  return std::nullopt;
}

bool GuidePointer::press(const Watched& where, QPoint at, Qt::MouseButton button, Qt::KeyboardModifiers keys) {
  if (guide_.isCorrecting() && button == Qt::LeftButton) {
    const std::uint8_t label = guide_.step().label;
    const bool erases = keys & Qt::ControlModifier;
    LabelStep stroke;
    stroke.tool = step::Paint{.radius_mm = guide_.brush_mm()};
    stroke.rest = LabelStep::kSurroundings;
    stroke.label = erases ? stroke.rest : label;
    if (erases) stroke.over = {{label}};
    const QString name = (erases ? tr("erase %1") : tr("paint %1")).arg(shared_.terms.nameOf(label));
    painting_ = shared_.labeling.beginStroke(std::move(stroke), name);
    if (painting_) shared_.labeling.strokeTo(patientAt(where, at));
    return true;
  }
  if (!guide_.takesClicks()) return false;
  const auto near = clickAt(where, at);
  if (button == Qt::RightButton && near) {
    guide_.removeClick(*near);
    return true;
  }
  if (button != Qt::LeftButton || keys != Qt::NoModifier) return false;
  dragged_ = near;
  pressed_ = at;
  added_ = false;
  return near.has_value();
}

bool GuidePointer::move(const Watched& where, QPoint at) {
  if (painting_) shared_.labeling.strokeTo(patientAt(where, at));
  if (dragged_) guide_.moveClick(*dragged_, patientAt(where, at));
  return painting_ || dragged_;
}

bool GuidePointer::release(const Watched& where, QPoint at) {
  if (std::exchange(painting_, false)) {
    shared_.labeling.endStroke();
    return true;
  }
  const auto from = std::exchange(pressed_, std::nullopt);
  if (std::exchange(dragged_, std::nullopt)) return true;
  // A longer motion is a drag of the crosshair.
  added_ = from && (at - *from).manhattanLength() < QApplication::startDragDistance();
  if (added_) guide_.addClick(patientAt(where, *from));
  return false;
}

/// A double click belongs to the view: removes the point that its first click has set.
bool GuidePointer::doubleClick(Qt::MouseButton button) {
  if (guide_.isCorrecting()) return true;
  if (button == Qt::LeftButton && std::exchange(added_, false) && !guide_.clicks_mm().empty())
    guide_.removeClick(guide_.clicks_mm().size() - 1);
  return false;
}

void GuidePointer::addKeys() {
  keys_.add({QStringLiteral("proceed"),
             {},
             {},
             {},
             {{Qt::Key_Return, {}, {}}, {Qt::Key_Enter, {}, {}}},
             [this](ui::KeyPress) { guide_.proceed(); },
             [this] { return guide_.isShown() && !guide_.isBusy(); }});
  keys_.add({QStringLiteral("removeLast"),
             {},
             {},
             {},
             {{Qt::Key_Delete, {}, {}}, {Qt::Key_Backspace, {}, {}}},
             [this](ui::KeyPress) { guide_.removeClick(guide_.clicks_mm().size() - 1); },
             [this] { return guide_.takesClicks() && !guide_.clicks_mm().empty(); }});
}

bool GuidePointer::eventFilter(QObject* watched, QEvent* event) {
  const auto where =
      std::ranges::find_if(watched_, [&](const Watched& w) { return w.widget->focusProxy() == watched; });
  if (where == watched_.end()) return false;
  const auto* mouse = static_cast<QMouseEvent*>(event);
  switch (event->type()) {
    case QEvent::MouseButtonPress:
      return press(*where, mouse->pos(), mouse->button(), mouse->modifiers());
    case QEvent::MouseMove:
      return move(*where, mouse->pos());
    case QEvent::MouseButtonRelease:
      return release(*where, mouse->pos());
    case QEvent::MouseButtonDblClick:
      return doubleClick(mouse->button());
    default:
      return keys_.handleKeyEvent(*event);
  }
}

}  // namespace insonate::prepare
