#include "HistogramPlot.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace insonate::ui {
namespace {

constexpr double kReach_px = 10, kMargin_px = 8, kFoot_px = 24;
constexpr double kArrow_HU = 10, kFine_HU = 1, kArrowOpacity = 0.02, kFineOpacity = 0.005;
using Function = views::TransferFunction;

}  // namespace

HistogramPlot::HistogramPlot(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Opacity curve over the histogram of the CT"));
  setAccessibleDescription(
      tr("Tab: next point. Arrow keys: move the point. Insert: add a point. Delete: remove the point. Enter: choose "
         "the color of the point."));
  setToolTip(tr("Opacity of each Hounsfield unit, in %% per millimeter of tissue, over the histogram of the CT.\nDrag "
                "a point to move it. A double click adds a point; a right click or Delete removes a point.\nTab "
                "selects the next point; arrow keys move the point, with Shift in fine steps; Enter chooses its color.")
                 .replace(QLatin1String("%%"), QLatin1String("%")));
}

QRectF HistogramPlot::field() const {
  return {kMargin_px, kMargin_px, width() - 2 * kMargin_px, height() - kMargin_px - kFoot_px};
}

// Most relevant opacities are low: a square root gives them more space.
QPointF HistogramPlot::placeOf(double hu, double opacity) const {
  const QRectF area = field();
  return {area.left() + area.width() * (hu - min_HU_) / (max_HU_ - min_HU_),
          area.bottom() - area.height() * std::sqrt(std::clamp(opacity, 0.0, 1.0))};
}

double HistogramPlot::huAt(double x) const {
  const QRectF area = field();
  return min_HU_ + (max_HU_ - min_HU_) * (x - area.left()) / std::max(1.0, area.width());
}

double HistogramPlot::opacityAt(double y) const {
  const QRectF area = field();
  const double high = std::clamp((area.bottom() - y) / std::max(1.0, area.height()), 0.0, 1.0);
  return high * high;
}

void HistogramPlot::fitRange() {
  const bool counted = !histogram_.counts.empty();
  min_HU_ = counted ? histogram_.min_HU : Function::kMin_HU;
  max_HU_ = counted ? histogram_.max_HU : 1600;
  if (function_.nodes.empty()) return;
  min_HU_ = std::min(min_HU_, function_.nodes.front().hu);
  max_HU_ = std::max(max_HU_, function_.nodes.back().hu);
}

void HistogramPlot::setHistogram(const views::HuHistogram& histogram) {
  histogram_ = histogram;
  fitRange();
  update();
}

void HistogramPlot::setFunction(const Function& function) {
  function_ = function;
  // The scale does not change during a drag.
  if (!dragging_) fitRange();
  update();
  if (selected_ >= int(function_.nodes.size())) select(int(function_.nodes.size()) - 1);
}

void HistogramPlot::setWindowLevel(std::optional<views::WindowLevel> window) {
  window_ = window;
  update();
}

void HistogramPlot::select(int node) {
  node = std::clamp(node, -1, int(function_.nodes.size()) - 1);
  if (node == selected_) return;
  selected_ = node;
  lastArrow_ = 0;
  update();
  Q_EMIT selectionChanged(node);
}

int HistogramPlot::nodeAt(QPointF place) const {
  int nearest = -1;
  double least = kReach_px;
  for (int node = 0; node < int(function_.nodes.size()); ++node) {
    const auto& at = function_.nodes[std::size_t(node)];
    const QPointF away = placeOf(at.hu, at.opacity) - place;
    const double distance = std::hypot(away.x(), away.y());
    if (distance <= least) nearest = node, least = distance;
  }
  return nearest;
}

void HistogramPlot::add(double hu, double opacity) {
  if (int(function_.nodes.size()) >= Function::kMaxNodes) return;
  Function wanted = function_;
  hu = std::clamp(std::round(hu), Function::kMin_HU, Function::kMax_HU);
  const auto after = std::upper_bound(wanted.nodes.begin(), wanted.nodes.end(), hu,
                                      [](double value, const auto& node) { return value < node.hu; });
  const int number = int(after - wanted.nodes.begin());
  wanted.nodes.insert(after, {hu, opacity, wanted.colorAt(hu)});
  Q_EMIT edited(wanted, 0, tr("point addition"));
  select(number);
}

void HistogramPlot::addBeside() {
  const auto& nodes = function_.nodes;
  if (nodes.empty()) return add((min_HU_ + max_HU_) / 2, 0.1);
  const auto at = std::size_t(std::max(0, selected_));
  const double before = nodes[at].hu - (at > 0 ? nodes[at - 1].hu : min_HU_);
  const double behind = (at + 1 < nodes.size() ? nodes[at + 1].hu : max_HU_) - nodes[at].hu;
  const double hu = nodes[at].hu + (behind >= before ? behind : -before) / 2;
  add(hu, function_.opacityAt(hu));
}

void HistogramPlot::remove(int node) {
  // Without nodes, nothing would be visible and nothing could be dragged.
  if (node < 0 || function_.nodes.size() < 2) return;
  Function wanted = function_;
  wanted.nodes.erase(wanted.nodes.begin() + node);
  Q_EMIT edited(wanted, 0, tr("point removal"));
}

void HistogramPlot::removeSelected() {
  remove(selected_);
}

void HistogramPlot::moveSelected(double hu, double opacity, int gesture) {
  if (selected_ < 0) return;
  Function wanted = function_;
  auto& nodes = wanted.nodes;
  const auto at = std::size_t(selected_);
  // Nodes do not pass each other.
  const double least = at > 0 ? nodes[at - 1].hu + Function::kMinGap_HU : Function::kMin_HU;
  const double most = at + 1 < nodes.size() ? nodes[at + 1].hu - Function::kMinGap_HU : Function::kMax_HU;
  nodes[at].hu = std::clamp(std::round(hu), least, std::max(least, most));
  nodes[at].opacity = std::clamp(opacity, 0.0, 1.0);
  if (wanted != function_) Q_EMIT edited(wanted, gesture, tr("point movement"));
}

void HistogramPlot::mousePressEvent(QMouseEvent* event) {
  const int node = nodeAt(event->localPos());
  if (node < 0 || dragging_) return;
  if (event->button() == Qt::RightButton) return remove(node);
  if (event->button() != Qt::LeftButton) return;
  select(node);
  lastArrow_ = 0;
  const auto& at = function_.nodes[std::size_t(node)];
  grip_ = event->localPos() - placeOf(at.hu, at.opacity);
  dragging_ = true;
  ++gesture_;
  Q_EMIT movingChanged(true);
}

void HistogramPlot::mouseMoveEvent(QMouseEvent* event) {
  if (!dragging_) {
    setCursor(nodeAt(event->localPos()) >= 0 ? Qt::PointingHandCursor : Qt::ArrowCursor);
    return;
  }
  const QPointF place = event->localPos() - grip_;
  moveSelected(huAt(place.x()), opacityAt(place.y()), gesture_);
}

void HistogramPlot::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !dragging_) return;
  dragging_ = false;
  fitRange();
  update();
  Q_EMIT movingChanged(false);
}

void HistogramPlot::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton) return;
  if (nodeAt(event->localPos()) >= 0) return Q_EMIT colorRequested();
  if (field().contains(event->localPos())) add(huAt(event->localPos().x()), opacityAt(event->localPos().y()));
}

void HistogramPlot::keyPressEvent(QKeyEvent* event) {
  const bool fine = event->modifiers() & Qt::ShiftModifier;
  const int key = event->key();
  const int across = key == Qt::Key_Right ? 1 : key == Qt::Key_Left ? -1 : 0;
  const int up = key == Qt::Key_Up ? 1 : key == Qt::Key_Down ? -1 : 0;
  if ((across != 0 || up != 0) && selected_ >= 0) {
    // Repeated presses of the same arrow are one step.
    if (key != lastArrow_) ++gesture_;
    lastArrow_ = key;
    const auto& at = function_.nodes[std::size_t(selected_)];
    moveSelected(at.hu + across * (fine ? kFine_HU : kArrow_HU),
                 at.opacity + up * (fine ? kFineOpacity : kArrowOpacity), gesture_);
    return;
  }
  lastArrow_ = 0;
  if (key == Qt::Key_Delete || key == Qt::Key_Backspace) return removeSelected();
  if (key == Qt::Key_Insert || key == Qt::Key_Plus) return addBeside();
  if ((key == Qt::Key_Return || key == Qt::Key_Enter) && selected_ >= 0) return Q_EMIT colorRequested();
  QWidget::keyPressEvent(event);
}

bool HistogramPlot::focusNextPrevChild(bool next) {
  const int node = selected_ + (next ? 1 : -1);
  if (!hasFocus() || node < 0 || node >= int(function_.nodes.size())) return QWidget::focusNextPrevChild(next);
  select(node);
  return true;
}

void HistogramPlot::focusInEvent(QFocusEvent* event) {
  if (event->reason() == Qt::TabFocusReason) select(0);
  if (event->reason() == Qt::BacktabFocusReason) select(int(function_.nodes.size()) - 1);
  QWidget::focusInEvent(event);
  update();
}

bool HistogramPlot::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int node = nodeAt(help->pos());
  if (node < 0) return QWidget::event(event);
  const auto& at = function_.nodes[std::size_t(node)];
  QToolTip::showText(help->globalPos(),
                     tr("%1 HU, opacity %2 % per millimeter").arg(at.hu).arg(at.opacity * 100, 0, 'f', 1), this);
  return true;
}

}  // namespace insonate::ui
