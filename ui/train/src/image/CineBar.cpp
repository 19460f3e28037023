#include "CineBar.h"

#include "../feature/CommandWords.h"
#include "../model/CaseModel.h"
#include "../model/LiveModel.h"

#include <insonate/ui/Theme.h>

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>

namespace insonate::train {
namespace {

constexpr int kSlider_px = 96, kShortSlider_px = 48;

/// In the order of views::CaliperKind.
constexpr const char* kMeasures[] = {"train.measure.distance", "train.measure.ellipse", "train.measure.angle"};

}  // namespace

CineBar::CineBar(CaseModel& patientCase, LiveModel& live, ui::Commands& commands, QWidget* parent)
    : QWidget(parent),
      patientCase_(patientCase),
      live_(live),
      slider_(new QSlider(Qt::Horizontal, this)),
      time_(new QLabel(this)),
      measure_(new QPushButton(tr("Measure"), this)),
      beside_(new QPushButton(tr("CT beside"), this)),
      save_(new QPushButton(tr("Save"), this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 4, 8, 4);
  row->setSpacing(8);
  slider_->setObjectName("cine");
  slider_->setAccessibleName(tr("Choice of an image from the last seconds before the freeze"));
  slider_->setToolTip(
      commands.toolTip(tr("Chooses an image from the last seconds before the freeze"), "train.image.step"));
  slider_->setFocusPolicy(Qt::TabFocus);
  slider_->setMinimumWidth(kSlider_px);
  time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance("-00.00 s"));
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(slider_, 1);
  row->addWidget(time_);
  measure_->setObjectName("measure");
  measure_->setToolTip(tr("Measure on the image or the CT, in mm and degrees"));
  measure_->setFocusPolicy(Qt::TabFocus);
  measure_->setMenu(buildMeasures(commands));
  row->addWidget(measure_);
  beside_->setObjectName("ctBesideButton");
  beside_->setAccessibleName(tr("CT beside the image"));
  beside_->setToolTip(commands.toolTip("train.image.ctBeside"));
  beside_->setCheckable(true);
  beside_->setFocusPolicy(Qt::TabFocus);
  row->addWidget(beside_);
  connect(beside_, &QPushButton::clicked, this, &CineBar::ctBesideChosen);
  save_->setToolTip(tr("Save the image (%1), or a clip of the last seconds").arg(keysOf(commands, "train.image.save")));
  save_->setObjectName("save");
  save_->setMenu(buildSaving(commands));
  save_->setFocusPolicy(Qt::TabFocus);
  row->addWidget(save_);

  connect(slider_, &QSlider::valueChanged, &live_, &LiveModel::showCine);
  connect(&live_, &LiveModel::frozenChanged, this, &CineBar::refresh);
  connect(&patientCase_, &CaseModel::caseChanged, this, &CineBar::refresh);
  connect(&live_, &LiveModel::pictureShown, this, &CineBar::refreshTime);
  connect(&live_, &LiveModel::staleChanged, this, &CineBar::refreshTime);
  refresh();
}

QMenu* CineBar::buildMeasures(ui::Commands& commands) {
  auto* menu = new QMenu(measure_);
  menu->setToolTipsVisible(true);
  for (std::size_t kind = 0; kind < measures_.size(); ++kind) {
    QAction* action = measures_[kind] = commands.action(kMeasures[kind]);
    measureNames_[kind] = commands.find(kMeasures[kind])->text;
    action->setCheckable(true);
    menu->addAction(action);
    // Qt changes the mark before the command is performed.
    connect(action, &QAction::triggered, this, [this] { setCaliper(caliper_); });
  }
  menu->addSeparator();
  menu->addAction(commands.action("train.measure.clear"));
  return menu;
}

QMenu* CineBar::buildSaving(ui::Commands& commands) {
  auto* menu = new QMenu(save_);
  menu->setToolTipsVisible(true);
  menu->addAction(commands.action("train.image.save"));
  menu->addAction(tr("Image as displayed ..."), this, &CineBar::saveScreen)
      ->setToolTip(tr("Saves the image with its overlays, and the CT beside it"));
  menu->addAction(tr("Clip ..."), this, &CineBar::saveClip)
      ->setToolTip(tr("Saves the last seconds as a video, a DICOM clip or numbered images"));
  menu->addSeparator();
  withMeasurements_ = menu->addAction(tr("Include measurements"));
  withMeasurements_->setObjectName("withMeasurements");
  withMeasurements_->setToolTip(tr("Includes measurements in saved images and clips"));
  withMeasurements_->setCheckable(true);
  withMeasurements_->setChecked(true);
  return menu;
}

bool CineBar::savesMeasurements() const {
  return withMeasurements_->isChecked();
}

void CineBar::setCaliper(int kind) {
  caliper_ = kind;
  for (int i = 0; i < int(measures_.size()); ++i) measures_[std::size_t(i)]->setChecked(i == kind);
  measure_->setText(kind < 0 ? tr("Measure") : measureNames_[std::size_t(kind)]);
  ui::setRole(measure_, kind < 0 ? "" : "on");
  measure_->style()->unpolish(measure_);
  measure_->style()->polish(measure_);
}

void CineBar::setCompact(bool compact) {
  compact_ = compact;
  slider_->setMinimumWidth(compact ? kShortSlider_px : kSlider_px);
  beside_->setText(compact ? tr("CT") : tr("CT beside"));
  layout()->setSpacing(compact ? 4 : 8);
  refreshTime();
}

void CineBar::setCtBesideOffered(bool offered) {
  beside_->setEnabled(offered);
}

void CineBar::setCtBeside(bool shown) {
  beside_->setChecked(shown);
}

void CineBar::refresh() {
  const bool frozen = live_.isFrozen();
  const QSignalBlocker quiet(slider_);
  slider_->setEnabled(frozen);
  slider_->setRange(0, frozen ? std::max(0, int(live_.cine().size()) - 1) : 0);
  slider_->setValue(live_.cineIndex());
  refreshTime();
}

void CineBar::refreshTime() {
  save_->setEnabled(live_.shown() != nullptr);
  time_->setVisible(!compact_ || live_.isFrozen());
  if (!live_.isFrozen() || live_.cine().empty()) {
    time_->setText(live_.shown() && !live_.isStale() ? tr("live") : QString());
    return;
  }
  const QSignalBlocker quiet(slider_);
  slider_->setValue(live_.cineIndex());
  const double ago_s = live_.cine().back()->time_s - live_.shown()->time_s;
  time_->setText(ago_s < 0.005 ? tr("now") : tr("-%1 s").arg(ago_s, 0, 'f', 2));
}

}  // namespace insonate::train
