#include "CineBar.h"

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

struct Measure {
  const char* name;
  const char* says;
};
constexpr Measure kMeasures[] = {{"Distance\tL", "Two points, in mm"},
                                 {"Ellipse\tO", "One axis, then the width, in mm and mm²"},
                                 {"Angle\tV", "Arm, corner, arm, in degrees"}};

}  // namespace

CineBar::CineBar(CaseModel& patientCase, LiveModel& live, QWidget* parent)
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
  slider_->setAccessibleName(tr("Image of the last seconds"));
  slider_->setToolTip(tr("The last seconds of a frozen image (comma and period step)"));
  slider_->setFocusPolicy(Qt::TabFocus);
  slider_->setMinimumWidth(kSlider_px);
  time_->setMinimumWidth(time_->fontMetrics().horizontalAdvance("-00.00 s"));
  time_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(slider_, 1);
  row->addWidget(time_);
  measure_->setObjectName("measure");
  measure_->setToolTip(tr("Measure on the image or the CT, in mm and degrees"));
  measure_->setFocusPolicy(Qt::TabFocus);
  measure_->setMenu(buildMeasures());
  row->addWidget(measure_);
  beside_->setObjectName("ctBesideButton");
  beside_->setAccessibleName(tr("CT beside the image"));
  beside_->setToolTip(tr("The CT of the same plane at the same scale, beside the image (C)"));
  beside_->setCheckable(true);
  beside_->setFocusPolicy(Qt::TabFocus);
  row->addWidget(beside_);
  connect(beside_, &QPushButton::clicked, this, &CineBar::ctBesideChosen);
  save_->setToolTip(tr("Save the image (Ctrl+P), or the last seconds"));
  save_->setObjectName("save");
  save_->setMenu(buildSaving());
  save_->setFocusPolicy(Qt::TabFocus);
  row->addWidget(save_);

  connect(slider_, &QSlider::valueChanged, &live_, &LiveModel::showCine);
  connect(&live_, &LiveModel::frozenChanged, this, &CineBar::refresh);
  connect(&patientCase_, &CaseModel::caseChanged, this, &CineBar::refresh);
  connect(&live_, &LiveModel::pictureShown, this, &CineBar::refreshTime);
  refresh();
}

QMenu* CineBar::buildMeasures() {
  auto* menu = new QMenu(measure_);
  menu->setToolTipsVisible(true);
  for (int i = 0; i < 3; ++i) {
    measures_[i] = menu->addAction(tr(kMeasures[i].name));
    measures_[i]->setToolTip(tr(kMeasures[i].says));
    measures_[i]->setCheckable(true);
    connect(measures_[i], &QAction::triggered, this, [this, i](bool on) { Q_EMIT calliperChosen(on ? i : -1); });
  }
  menu->addSeparator();
  auto* clear = menu->addAction(tr("Remove all\tDelete"));
  connect(clear, &QAction::triggered, this, &CineBar::clearCallipers);
  return menu;
}

QMenu* CineBar::buildSaving() {
  auto* menu = new QMenu(save_);
  menu->setToolTipsVisible(true);
  menu->addAction(tr("Image ...\tCtrl+P"), this, &CineBar::savePicture)
      ->setToolTip(tr("Saves the image at its own resolution, with its depth scale in mm"));
  menu->addAction(tr("As on the screen ..."), this, &CineBar::saveScreen)
      ->setToolTip(tr("Saves the image with its overlays, and the CT beside it"));
  menu->addAction(tr("Clip ..."), this, &CineBar::saveClip)
      ->setToolTip(tr("Saves the last seconds as a folder of numbered images"));
  menu->addSeparator();
  withMeasurements_ = menu->addAction(tr("With measurements"));
  withMeasurements_->setObjectName("withMeasurements");
  withMeasurements_->setToolTip(tr("Includes measurements in saved images and clips"));
  withMeasurements_->setCheckable(true);
  withMeasurements_->setChecked(true);
  return menu;
}

bool CineBar::savesMeasurements() const {
  return withMeasurements_->isChecked();
}

void CineBar::setCalliper(int kind) {
  for (int i = 0; i < 3; ++i) measures_[i]->setChecked(i == kind);
  measure_->setText(kind < 0 ? tr("Measure") : tr(kMeasures[kind].name).section('\t', 0, 0));
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
    time_->setText(live_.shown() ? tr("live") : QString());
    return;
  }
  const QSignalBlocker quiet(slider_);
  slider_->setValue(live_.cineIndex());
  const double ago_s = live_.cine().back()->time_s - live_.shown()->time_s;
  time_->setText(ago_s < 0.005 ? tr("now") : tr("-%1 s").arg(ago_s, 0, 'f', 2));
}

}  // namespace insonate::train
