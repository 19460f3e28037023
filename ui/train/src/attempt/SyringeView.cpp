#include "SyringeView.h"

#include "../model/CaseModel.h"
#include "../model/Disclosure.h"
#include "../model/HapticControl.h"
#include "AttemptControl.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/Text.h>
#include <insonate/ui/Theme.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kFrame_ms = 40, kWidth_px = 92, kHeight_px = 22;
/// A 5 ml syringe in so many seconds.
constexpr double kVenousFill_s = 4, kArterialFill_s = 2;
constexpr double kBeats_perMin = 70;
const QColor kDark(0x6b, 0x14, 0x20), kBright(0xd8, 0x2a, 0x2a), kFoam(0x9f, 0xb4, 0xc2);

QColor colorOf(SyringeView::Content content) {
  switch (content) {
    case SyringeView::Content::DarkBlood:
      return kDark;
    case SyringeView::Content::BrightBlood:
      return kBright;
    default:
      return kFoam;
  }
}

}  // namespace

SyringeView::SyringeView(DisclosureModel& disclosure, HapticControl& hands, CaseModel& patientCase,
                         AttemptControl& attempt, const ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      disclosure_(disclosure),
      hands_(hands),
      patientCase_(patientCase),
      attempt_(attempt),
      commands_(commands) {
  setObjectName("syringe");
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  timer_.setInterval(kFrame_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { draw(); });
  connect(&attempt_, &AttemptControl::aspiratingChanged, this, [this] {
    attempt_.isAspirating() ? (clock_.start(), timer_.start()) : timer_.stop();
    tell();
  });
  connect(&attempt_, &AttemptControl::needleReplaced, this, [this] { empty(); });
  connect(&attempt_, &AttemptControl::viewChanged, this, [this] {
    const bool isOff = attempt_.isRunning() && !attempt_.view().line.isSyringeOn;
    if (std::exchange(isOff_, isOff) != isOff) isOff ? empty() : tell();
  });
  connect(&patientCase_, &CaseModel::caseChanged, this, [this] { empty(); });
  connect(&disclosure_, &DisclosureModel::changed, this, [this] { tell(); });
  tell();
}

QSize SyringeView::sizeHint() const {
  return {kWidth_px, kHeight_px};
}

void SyringeView::empty() {
  content_ = Content::Nothing;
  level_ = beat_ = 0;
  tell();
}

void SyringeView::draw() {
  const double step_s = std::min(0.2, double(clock_.restart()) / 1000);
  const auto& needle = hands_.needle();
  const Content now = needle && needle->state.inBody ? aspiratedContent(needle->state.in) : Content::Nothing;
  if (now == Content::Nothing) return;
  const bool other = std::exchange(content_, now) != now;
  beat_ = std::fmod(beat_ + step_s * kBeats_perMin / 60, 1.0);
  // Ejection is the first third of a beat.
  const double flow = now != Content::BrightBlood ? 1 / kVenousFill_s
                      : beat_ < 0.35              ? 3 * std::sin(beat_ / 0.35 * std::numbers::pi) / kArterialFill_s
                                                  : 0;
  level_ = std::min(1.0, level_ + flow * step_s);
  other ? tell() : update();
}

void SyringeView::tell() {
  QString tip = commands_.toolTip(tr("Content of the syringe"), "train.attempt.aspirate");
  if (disclosure_.current().anatomy)
    tip +=
        tr(": dark red, non-pulsatile blood comes from a vein, bright red, pulsatile blood from an artery, air from "
           "lung or airway");
  setToolTip(tip);
  setAccessibleName(tr("Syringe: %1").arg(words()));
  update();
  Q_EMIT changed();
}

QString SyringeView::words() const {
  return isOff_ ? tr("syringe detached") : ui::qt(displayText(content_, attempt_.isAspirating()));
}

/// Lying: the needle's end on the left, the plunger on the right.
void SyringeView::paintEvent(QPaintEvent*) {
  if (isOff_) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor line = ui::toQColor(attempt_.isAspirating() ? views::theme::kText : views::theme::kQuiet);
  const QRectF barrel(12, 4, 64, kHeight_px - 8);
  const bool pulls = attempt_.isAspirating() || level_ > 0;
  // An artery pushes the plunger with each beat.
  const double push = content_ == Content::BrightBlood && timer_.isActive() && beat_ < 0.35
                          ? 2 * std::sin(beat_ / 0.35 * std::numbers::pi)
                          : 0;
  const double plunger = barrel.left() + (pulls ? std::max(0.18, level_) : 0.04) * (barrel.width() - 4) + push;
  if (level_ > 0)
    painter.fillRect(QRectF(barrel.left(), barrel.top(), plunger - barrel.left(), barrel.height()), colorOf(content_));
  if (content_ == Content::Air && level_ > 0) {
    painter.setPen(QPen(ui::toQColor(views::theme::kGround), 1));
    for (double x = barrel.left() + 5; x < plunger - 3; x += 8)
      painter.drawEllipse(QPointF(x, barrel.center().y() + 2 * std::sin(x)), 2.2, 2.2);
  }
  painter.setPen(QPen(line, 1));
  painter.drawRect(barrel);
  painter.drawLine(QPointF(1, barrel.center().y()), QPointF(barrel.left(), barrel.center().y()));
  for (int tick = 1; tick < 5; ++tick) {
    const double x = barrel.left() + tick * barrel.width() / 5;
    painter.drawLine(QPointF(x, barrel.top()), QPointF(x, barrel.top() + 3));
  }
  painter.fillRect(QRectF(plunger, barrel.top() + 1, 4, barrel.height() - 2), line);
  const double end = std::min<double>(width() - 2, plunger + 24 + (barrel.right() - plunger) * 0.4);
  painter.drawLine(QPointF(plunger + 4, barrel.center().y()), QPointF(end, barrel.center().y()));
  painter.drawLine(QPointF(end, barrel.top()), QPointF(end, barrel.bottom()));
}

}  // namespace insonate::train
