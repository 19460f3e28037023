#include "AttemptStrip.h"

#include "../feature/CommandWords.h"
#include "../model/CaseModel.h"
#include "../model/Disclosure.h"
#include "../model/HapticControl.h"
#include "AttemptControl.h"
#include "AttemptWords.h"
#include "SyringeView.h"

#include <insonate/ui/StateColors.h>
#include <insonate/ui/Theme.h>

#include <QHBoxLayout>
#include <QLabel>
#include <cmath>

namespace insonate::train {
namespace {

/// From here on there is room for the time to the vein, which the panel tells, too, and for both rows beside each
/// other.
constexpr int kWithTime_px = 440, kOneRow_px = 1080;
constexpr int kSpacing = 12;

QHBoxLayout* stripRow(QBoxLayout& rows) {
  auto* row = new QHBoxLayout;
  row->setSpacing(kSpacing);
  rows.addLayout(row);
  return row;
}

}  // namespace

AttemptStrip::AttemptStrip(DisclosureModel& disclosure, HapticControl& hands, CaseModel& patientCase,
                           AttemptControl& attempt, const ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      disclosure_(disclosure),
      hands_(hands),
      patientCase_(patientCase),
      attempt_(attempt),
      commands_(commands),
      rows_(new QBoxLayout(QBoxLayout::TopToBottom, this)),
      row_(stripRow(*rows_)) {
  setObjectName("attemptStrip");
  rows_->setContentsMargins(8, 4, 8, 0);
  rows_->setSpacing(2);
  time_ =
      number("attemptTime", QStringLiteral("88:88"), tr("Time since the start of the attempt, in minutes and seconds"));
  vein_ = number("attemptVein", tr("vein 8"), tr("Number of punctures of the vein"));
  artery_ = number("attemptArtery", tr("artery 8"), tr("Number of punctures of the artery"));
  double_ = number("attemptDouble", tr("posterior wall 8"),
                   tr("Number of posterior wall punctures: the needle passed out through the far wall of the vein"));
  toVein_ = number("attemptToVein", tr("to vein 888.8 s"),
                   tr("Time from skin puncture to vein puncture in the same needle pass, in s"));
  used_ = number("attemptUsed", tr("used 8"), tr("Number of insertions with a used needle"));
  row_->addStretch(1);
  row_ = stripRow(*rows_);
  needle_ = number("attemptNeedle", QStringLiteral("▲ wrong place"), {});
  needle_->setTextFormat(Qt::RichText);
  needle_->setWordWrap(true);
  row_->setStretch(0, 4);  // names of vessels are longer than words for blood
  drawn_ = number("attemptDrawn", {}, commands_.toolTip(tr("Content of the syringe"), "train.attempt.aspirate"));
  syringe_ = new SyringeView(disclosure_, hands_, patientCase_, attempt, commands_, this);
  drawn_->setWordWrap(true);
  drawn_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row_->setStretch(1, 3);
  row_->addWidget(syringe_);
  // The wide one must not keep its column wide.
  setMinimumWidth(200);
  connect(&attempt_, &AttemptControl::viewChanged, this, [this] { refresh(); });
  connect(&attempt_, &AttemptControl::stateChanged, this, [this] { refresh(); });
  connect(&attempt_, &AttemptControl::aspiratingChanged, this, [this] { refresh(); });
  connect(syringe_, &SyringeView::changed, this, [this] { drawn_->setText(syringe_->words()); });
  refresh();
}

/// As wide as it will get, so that the next one does not move.
QLabel* AttemptStrip::number(const char* object, const QString& widest, const QString& says) {
  auto* label = new QLabel(this);
  label->setObjectName(QLatin1String(object));
  label->setToolTip(says);
  label->setMinimumWidth(fontMetrics().horizontalAdvance(widest) + 2);
  row_->addWidget(label);
  return label;
}

void AttemptStrip::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const bool isOneRow = width() >= kOneRow_px;
  rows_->setDirection(isOneRow ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  // The image must not change its scale when the name of a vessel needs a second line.
  for (QLabel* label : {needle_, drawn_}) label->setMinimumHeight((isOneRow ? 1 : 2) * fontMetrics().lineSpacing() + 4);
  refresh();
}

void AttemptStrip::refresh() {
  using State = AttemptControl::State;
  const bool made = attempt_.isRunning() || attempt_.state() == State::Writing;
  setVisible(made || attempt_.isAspirating());
  const MetricValues& metrics = attempt_.view().metrics;
  const bool told = made && disclosure_.current().anatomy;
  for (QLabel* label : {vein_, artery_, double_, used_}) label->setVisible(told);
  toVein_->setVisible(told && width() >= kWithTime_px);
  time_->setVisible(made);
  time_->setText(clockOf(attempt_.view().time_s));
  time_->setAccessibleName(tr("Time %1").arg(time_->text()));
  vein_->setText(tr("vein %1").arg(ui::valueOf(Metric::VeinPunctures, metrics[Metric::VeinPunctures])));
  artery_->setText(tr("artery %1").arg(ui::valueOf(Metric::ArteryPunctures, metrics[Metric::ArteryPunctures])));
  double_->setText(tr("posterior wall %1")
                       .arg(ui::valueOf(Metric::PosteriorWallPunctures, metrics[Metric::PosteriorWallPunctures])));
  toVein_->setText(tr("to vein %1").arg(ui::valueOf(Metric::TimeToVein, metrics[Metric::TimeToVein])));
  used_->setText(tr("used %1").arg(ui::valueOf(Metric::UsedNeedleInsertions, metrics[Metric::UsedNeedleInsertions])));
  needle_->setVisible(made);
  refreshNeedle();
}

void AttemptStrip::refreshNeedle() {
  const NeedlePlace place = attempt_.view().needle;
  const Disclosure& told = disclosure_.current();
  const QString vessel = told.anatomy ? QString::fromStdString(attempt_.view().vessel) : QString();
  const ui::PlaceWords words = ui::displayText(disclosed(place, told), vessel);
  needle_->setToolTip((told.anatomy ? tr("Position of the needle. Green: in the vein; red: in a wrong place; yellow: "
                                         "the needle was already used (%1 takes a new needle)")
                                    : tr("State of the needle: new, inserted or already used (%1 takes a new needle)"))
                          .arg(keysOf(commands_, "train.attempt.newNeedle")));
  // Until the needle is in a vessel, the user turns it.
  const NeedlePlacement* held = hands_.needleHand();
  const bool turns = held && (place == NeedlePlace::Clean || place == NeedlePlace::UnderSkin);
  const QString state =
      turns ? tr("%1, %2° to the skin").arg(words.words).arg(std::lround(held->state().angle_deg)) : words.words;
  // The sign has the color: words of that color would be hard to read.
  needle_->setText(QStringLiteral("<span style='color:%1'>%2</span> %3")
                       .arg(ui::toQColor(ui::colorOf(disclosed(place, told))).name(), words.sign, state));
  needle_->setAccessibleName(tr("Needle: %1").arg(state));
}

}  // namespace insonate::train
