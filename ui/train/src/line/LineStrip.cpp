#include "LineStrip.h"

#include "../attempt/AttemptControl.h"
#include "../model/HapticControl.h"
#include "../model/LineWords.h"
#include "WireHand.h"

#include <insonate/ui/Commands.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

constexpr double kMove_mm = 5;

}  // namespace

LineStrip::LineStrip(AttemptControl& attempt, HapticControl& hands, const ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      attempt_(attempt),
      hand_(new WireHand(
          hands, [this](Instrument instrument, double by_mm) { return attempt_.moveInstrument(instrument, by_mm); },
          [this] { return attempt_.wireResistance_N(); }, this)),
      menu_(new QMenu(this)) {
  setObjectName("lineStrip");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 0);
  row->setSpacing(4);
  acts_ = ui::pushButton("lineActs", tr("Acts"), commands.toolTip("train.line.acts"), Qt::TabFocus);
  acts_->setMenu(menu_);
  row->addWidget(acts_);
  row->addStretch(1);
  buildMoves(*row, commands);
  // The buttons must not keep the column wide.
  setMinimumWidth(200);
  connect(menu_, &QMenu::aboutToShow, this, [this] { fillMenu(); });
  connect(&attempt_, &AttemptControl::stateChanged, this, [this] { refresh(); });
  connect(&attempt_, &AttemptControl::viewChanged, this, [this] { refresh(); });
  connect(&hands, &HapticControl::handsChanged, this, [this] { offerNeedle(); });
  connect(&repeating_, &QTimer::timeout, this, [this] { move(heldBy_mm_, true); });
  refresh();
}

void LineStrip::buildMoves(QBoxLayout& row, const ui::Commands& commands) {
  instrument_ = new QComboBox;
  instrument_->setObjectName("lineInstrument");
  instrument_->setAccessibleName(tr("Instrument"));
  instrument_->setToolTip(commands.toolTip("train.line.instrument"));
  instrument_->setFocusPolicy(Qt::TabFocus);
  for (const Instrument one : {Instrument::Wire, Instrument::Dilator, Instrument::Catheter})
    instrument_->addItem(titleOf(one), int(one));
  row.addWidget(instrument_);
  const auto addMove = [&](const char* object, const QString& text, double by_mm) {
    auto* button = ui::pushButton(object, text, commands.toolTip("train.line.move"), Qt::TabFocus);
    connect(button, &QPushButton::pressed, this, [this, by_mm] { holdDown(by_mm); });
    connect(button, &QPushButton::released, &repeating_, &QTimer::stop);
    moves_.push_back(button);
    row.addWidget(button);
  };
  addMove("lineWithdraw", tr("withdraw"), -kMove_mm);
  addMove("lineAdvance", tr("advance"), kMove_mm);
  depth_ = new QLabel;
  depth_->setObjectName("lineDepth");
  depth_->setToolTip(tr("Length of the instrument below the skin"));
  depth_->setMinimumWidth(depth_->fontMetrics().horizontalAdvance(QStringLiteral("600 mm")));
  depth_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row.addWidget(depth_);
  connect(instrument_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
    takeChosen();
    refresh();
  });
}

Instrument LineStrip::chosen() const {
  return Instrument(instrument_->currentData().toInt());
}

void LineStrip::chooseNext() {
  instrument_->setCurrentIndex((instrument_->currentIndex() + 1) % instrument_->count());
}

void LineStrip::move(double by_mm, bool isHeldDown) {
  // A button or key that is held down past a stop must not push on: that would kink the wire.
  if (chosen() == Instrument::Needle || (isHeldDown && isStopped_)) return;
  constexpr double kLeast_mm = 0.1;
  isStopped_ = std::abs(attempt_.moveInstrument(chosen(), by_mm)) < std::abs(by_mm) - kLeast_mm;
}

/// Moves at once, and repeats the move until the button is released.
void LineStrip::holdDown(double by_mm) {
  constexpr int kFirst_ms = 300, kNext_ms = 100;
  heldBy_mm_ = by_mm;
  move(by_mm, false);
  repeating_.setInterval(kNext_ms);
  QTimer::singleShot(kFirst_ms, this, [this, by_mm] {
    const bool isDown = std::ranges::any_of(moves_, [](const QPushButton* one) { return one->isDown(); });
    if (isDown && heldBy_mm_ == by_mm) repeating_.start();
  });
}

/// The device moves what is chosen, during the attempt.
void LineStrip::takeChosen() {
  hand_->take(isVisibleTo(parentWidget()) ? chosen() : Instrument::Needle);
}

/// With a device, the needle is one of the things that the hand can move, and the first.
void LineStrip::offerNeedle() {
  const int at = instrument_->findData(int(Instrument::Needle));
  if (hand_->canGrip() == (at >= 0)) return;
  if (at >= 0) return instrument_->removeItem(at);
  instrument_->insertItem(0, titleOf(Instrument::Needle), int(Instrument::Needle));
  instrument_->setCurrentIndex(0);
}

void LineStrip::openActs() {
  if (isVisible()) acts_->showMenu();
}

void LineStrip::addAct(QMenu& menu, LineAct act, int lumen) {
  const LineState& line = attempt_.view().line;
  QAction* action = menu.addAction(titleOf(act, lumen), this, [this, act, lumen] { attempt_.perform(act, lumen); });
  const auto index = static_cast<std::size_t>(lumen) - 1;
  const bool isDone = act == LineAct::AspirateLumen ? line.isAspirated[index]
                      : act == LineAct::FlushLumen  ? line.isFlushed[index]
                      : act == LineAct::NickSkin    ? line.isNicked
                                                    : line.count(act) > 0;
  // Syringe, finger and hand can be put back; whether they were once taken away says nothing.
  const bool isReversible = act >= LineAct::DetachSyringe && act <= LineAct::ReleaseWire;
  action->setCheckable(!isReversible);
  action->setChecked(isDone && !isReversible);
  // The test shows what an operator would know: whether an act is possible with these hands, and not whether it is due.
  action->setEnabled(refusalOf(line, act, lumen).empty());
}

/// Acts in the order of the procedure; those at a place where the hands cannot do them are gray.
void LineStrip::fillMenu() {
  menu_->clear();
  qDeleteAll(menu_->findChildren<QMenu*>(QString(), Qt::FindDirectChildrenOnly));
  const auto section = [this](const QString& title, std::initializer_list<LineAct> acts) {
    menu_->addSection(title);
    for (const LineAct act : acts) addAct(*menu_, act);
  };
  using enum LineAct;
  section(tr("Before the puncture"), {CheckConsent, TimeOut, CoverProbe, Anesthetize});
  section(tr("Hub"), {DetachSyringe, AttachSyringe, CoverHub, UncoverHub});
  section(tr("Proof of the vein"), {MeasurePressure, FlushForBubbles, TrustBloodColor});
  section(tr("Wire"), {HoldWire, ReleaseWire, NickSkin});
  menu_->addSection(tr("Catheter"));
  QMenu* lumens = menu_->addMenu(tr("Lumens"));
  for (int lumen = 1; lumen <= kCatheterLumens; ++lumen)
    addAct(*lumens, AspirateLumen, lumen), addAct(*lumens, FlushLumen, lumen);
  for (const LineAct act : {SecureCatheter, ApplyDressing, CheckLungSliding}) addAct(*menu_, act);
}

void LineStrip::refresh() {
  const bool isShown = attempt_.isRunning() && hasLine(attempt_.procedure());
  setVisible(isShown);
  if (std::exchange(wasShown_, isShown) != isShown) {
    instrument_->setCurrentIndex(0);
    takeChosen();
  }
  const LineState& line = attempt_.view().line;
  const double in_mm = line.length_mm(chosen());
  for (QPushButton* one : moves_) one->setEnabled(chosen() != Instrument::Needle);
  if (chosen() == Instrument::Needle) return depth_->clear();
  QString text = in_mm > 0 ? tr("%1 mm").arg(in_mm, 0, 'f', 0) : tr("outside");
  if (chosen() == Instrument::Wire && line.isWireIn() && !line.isWireHeld) text += tr(", not held");
  depth_->setText(text);
}

}  // namespace insonate::train
