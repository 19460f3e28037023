#include "Canvas.h"

#include <insonate/ui/ViewWidget.h>

#include <QApplication>
#include <QKeyEvent>
#include <QSplitterHandle>
#include <QStyle>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::ui {
namespace {

constexpr char kRoom[] = "insonateViewRoom";
constexpr double kFrame_ms = 16;
/// Time for other work before the next rendering, as a share of a slow rendering's duration.
constexpr double kShareForOthers = 0.3;

QWidget* roomOf(QWidget* view) {
  for (QWidget* parent = view->parentWidget(); parent; parent = parent->parentWidget())
    if (parent->property(kRoom).toBool()) return parent;
  return view->parentWidget() ? view->parentWidget() : view;
}

}  // namespace

void prepareGraphics() {
  QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  // Lines stay sharp with whole factors; text gets its exact size from the screen's resolution.
  QGuiApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::Round);
}

void setMaximizeArea(QWidget* room) {
  room->setProperty(kRoom, true);
}

ViewWidget::ViewWidget(std::shared_ptr<views::View> view, const QString& name, QWidget* parent)
    : QFrame(parent), view_(std::move(view)), canvas_(new Canvas(*view_, this)), timer_(new QTimer(this)) {
  setObjectName(QStringLiteral("viewFrame"));
  setAccessibleName(name);
  canvas_->setAccessibleName(name);
  setFocusProxy(canvas_);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(1, 1, 1, 1);
  box->addWidget(canvas_);

  timer_->setSingleShot(true);
  connect(timer_, &QTimer::timeout, this, &ViewWidget::renderNow);
  canvas_->onFocus = [this](bool focused) {
    setProperty("focused", focused);
    style()->unpolish(this), style()->polish(this);
  };
  canvas_->onDoubleClick = [this] {
    if (maximizeOnDoubleClick_) setMaximized(!maximized_);
    return maximizeOnDoubleClick_;
  };
  canvas_->onStale = [this] { want(); };
  view_->setRenderRequested([this] { want(); });
  view_->setWakeListener([this] {
    QMetaObject::invokeMethod(
        this, [this] { want(); }, Qt::QueuedConnection);
  });
  canvas_->onDrawn = [this](double took_ms) { drawn(took_ms); };
  want();
}

ViewWidget::~ViewWidget() {
  view_->setRenderRequested({});
  view_->setWakeListener({});
  canvas_->onFocus = nullptr;
  canvas_->onStale = nullptr;
  canvas_->onDrawn = nullptr;
  delete canvas_;  // its leave event, sent during its deletion, still needs the view
}

void ViewWidget::want() {
  // One request is enough while a thread draws.
  if (canvas_->isDrawing()) wantedAgain_ = true;
  if (timer_->isActive() || canvas_->isDrawing()) return;
  const double since_ms = sinceRender_.isValid() ? double(sinceRender_.nsecsElapsed()) / 1e6 : kFrame_ms;
  const double wait_ms =
      std::max(kFrame_ms - lastRender_ms_, view_->canDrawOnThread() ? 0 : lastRender_ms_ * kShareForOthers);
  timer_->start(int(std::max(0.0, wait_ms - since_ms)));
}

void ViewWidget::renderNow() {
  if (!canvas_->isVisible()) {
    missed_ = true;
    return;
  }
  canvas_->fit();
  timer_->stop();
  canvas_->render();
}

void ViewWidget::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  if (std::exchange(missed_, false)) want();
}

void ViewWidget::drawn(double took_ms) {
  lastRender_ms_ = took_ms;
  sinceRender_.start();
  ++renderings_;
  if (std::exchange(wantedAgain_, false)) want();
  Q_EMIT rendered();
}

bool ViewWidget::isDrawing() const {
  return canvas_->isDrawing() || (view_->canDrawOnThread() && timer_->isActive());
}

void ViewWidget::forget() {
  canvas_->forget();
  want();
}

void ViewWidget::setMaximized(bool maximized) {
  if (maximized == maximized_) return;
  maximized_ = maximized;
  if (maximized) {
    QWidget* room = roomOf(this);
    for (QWidget* inner = this; inner != room; inner = inner->parentWidget()) {
      for (QWidget* other : inner->parentWidget()->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        // A splitter hides its handles itself.
        if (other == inner || other->isHidden() || other->isWindow() || qobject_cast<QSplitterHandle*>(other)) continue;
        other->hide();
        hidden_.emplace_back(other);
      }
    }
  } else {
    for (const QPointer<QWidget>& other : hidden_)
      if (other) other->show();
    hidden_.clear();
  }
  setFocus();
  Q_EMIT maximizedChanged(maximized);
}

void ViewWidget::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_M && !event->modifiers())
    setMaximized(!maximized_);
  else if (event->key() == Qt::Key_Escape && maximized_)
    setMaximized(false);
  else
    QFrame::keyPressEvent(event);
}

}  // namespace insonate::ui
