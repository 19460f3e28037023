#include "HeldPress.h"

#include "../model/ProbeMotion.h"

#include <QCoreApplication>
#include <QKeyEvent>

namespace insonate::train {
namespace {

constexpr int kPressTick_ms = 16;

}  // namespace

HeldPress::HeldPress(ProbeMotion& motion, QObject* parent) : QObject(parent), motion_(motion) {
  connect(&timer_, &QTimer::timeout, this, [this] { goOn(); });
}

void HeldPress::begin(double step_mm) {
  end();
  direction_ = step_mm < 0 ? -1 : 1;
  told_s_ = 0;
  motion_.beginGesture();
  motion_.move(HandAxis::Press, step_mm);
  clock_.start();
  timer_.start(kPressTick_ms);
  QCoreApplication::instance()->installEventFilter(this);
}

void HeldPress::end() {
  timer_.stop();
  QCoreApplication::instance()->removeEventFilter(this);
}

void HeldPress::goOn() {
  const double held_s = double(clock_.elapsed() - kBegins_ms) / 1000;
  if (held_s <= 0) return;
  motion_.move(HandAxis::Press, direction_ * kSpeed_mmPerS * (held_s - told_s_));
  told_s_ = held_s;
}

bool HeldPress::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (event->type() == QEvent::KeyRelease) {
    const auto& key = *static_cast<QKeyEvent*>(event);
    // Plus comes up as Equal where Shift came up first: any key ends it, so that none is missed.
    if (!key.isAutoRepeat() && key.key() != Qt::Key_Shift) end();
  } else if (event->type() == QEvent::WindowDeactivate || event->type() == QEvent::ApplicationDeactivate) {
    // The release would go to another window.
    end();
  }
  return false;
}

}  // namespace insonate::train
