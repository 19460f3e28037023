// The part of the workspace that lays out its columns, and what stands in the middle one.
#include "TrainParts.h"
#include "attempt/AttemptControl.h"
#include "devices/DevicePanel.h"
#include "image/CineBar.h"
#include "image/CtBeside.h"
#include "image/EqualPanes.h"
#include "patient3d/PatientViews.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/ViewWidget.h>

#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace insonate::train {

void TrainWorkspace::Parts::setLeftHanded(bool on) {
  leftHanded_->setChecked(on);
  QWidget *first = on ? static_cast<QWidget*>(patient) : leftColumn_, *last = on ? leftColumn_ : patient;
  if (columns->widget(0) == first) return;
  QList<int> sizes = columns->sizes();
  std::reverse(sizes.begin(), sizes.end());
  columns->insertWidget(0, first);
  columns->addWidget(last);
  for (int i = 0; i < columns->count(); ++i)
    columns->setStretchFactor(i, columns->widget(i) == leftColumn_ ? 0 : columns->widget(i) == patient ? 1 : 3);
  columns->setSizes(sizes);
}

void TrainWorkspace::Parts::showDevices() {
  if (!devices) {
    devices = new DevicePanel(model.hands, &workspace_);
    connect(devices, &DevicePanel::refused, &model.status, &StatusLine::say);
  }
  devices->show();
  devices->raise();
  devices->activateWindow();
}

void TrainWorkspace::Parts::setCompact(bool compact) {
  cine_->setCompact(compact);
  patient->setCompact(compact);
}

void TrainWorkspace::Parts::expandPatientColumn(bool more) {
  QList<int> widths = columns->sizes();
  if (more) {
    widthsBefore_ = widths;
    const int aside = columns->indexOf(patient), shared = widths[1] + widths[aside];
    widths[1] = shared / 2, widths[aside] = shared - shared / 2;
    columns->setSizes(widths);
  } else if (widthsBefore_.size() == widths.size()) {
    columns->setSizes(widthsBefore_);
  }
}

void TrainWorkspace::Parts::setCtBeside(bool on) {
  if (on && !model.disclosure.mayShowAnatomy()) return besideAction_->setChecked(false);
  besideAction_->setChecked(on);
  // Leaving full size would bring back what was there before.
  for (ui::ViewWidget* view : {imageWidget_, &beside_->widget(), &patient->sceneWidget(), &patient->mprWidget()})
    view->setMaximised(false);
  beside_->setShown(on);
  cine_->setCtBeside(on);
}

/// The image's place, and the line under it about structures that the case lacks.
QWidget* TrainWorkspace::Parts::buildOffer() {
  auto* offer = new QWidget;
  offer->setObjectName("placeOffer");
  auto* words =
      new QLabel(tr("This case has no start pose, and none was found automatically.\n\nPlace the probe, or click on "
                    "the skin in 3D. Prepare can save a start pose with the case."));
  words->setWordWrap(true);
  words->setAlignment(Qt::AlignCenter);
  auto* place = new QPushButton(tr("Place probe on skin"));
  place->setObjectName("placeOnSkin");
  place->setToolTip(tr("Moves the probe to the skin in front, as near to the middle of the scan as possible"));
  ui::setRole(place, "primary");
  connect(place, &QPushButton::clicked, this, [this] { model.motion.placeOnSkin(); });
  auto* box = new QVBoxLayout(offer);
  box->setContentsMargins(ui::kLargeGap, ui::kLargeGap, ui::kLargeGap, ui::kLargeGap);
  box->setSpacing(ui::kLargeGap);
  box->addStretch();
  box->addWidget(words);
  box->addWidget(place, 0, Qt::AlignHCenter);
  box->addStretch();
  vesselNote_ = new QLabel(
      tr("This case has no vein and no artery, so the image shows none. Label them under Prepare, or in 3D Slicer or "
         "ITK-SNAP and reload the case there (F5)."));
  vesselNote_->setObjectName("vesselNote");
  vesselNote_->setWordWrap(true);
  vesselNote_->setContentsMargins(12, ui::kSmallGap, 12, ui::kSmallGap);
  ui::setRole(vesselNote_, "quiet");
  return offer;
}

void TrainWorkspace::Parts::showOffer() {
  const bool there = model.patientCase.patient() != nullptr, waits = there && model.motion.isUnplaced();
  offer_->setVisible(waits);
  pictures_->setVisible(there && !waits);
  // Without an image, this is all there is to see; the image comes once the probe is placed.
  if (waits == std::exchange(ready, waits)) return;
  Q_EMIT workspace_.readyChanged();
}

void TrainWorkspace::Parts::showVesselNote() {
  vesselNote_->setVisible(model.patientCase.patient() && model.patientCase.lacksVessels());
}

void TrainWorkspace::Parts::showOpening(const QString& what) {
  empty_->setText(what.isEmpty()
                      ? tr("No case is open.\n\nDrop a case, a folder of DICOM files or a CT file on the window,\n"
                           "or choose Case > Open case (Ctrl+O), or Case > Built-in neck (Ctrl+T).")
                      : tr("%1 ...").arg(what));
}

}  // namespace insonate::train
