#include "VesselPanel.h"

#include "../model/PrepareModel.h"
#include "../model/SliceSettings.h"
#include "../model/StructureAppearance.h"
#include "../model/TermsEditor.h"
#include "SectionStrip.h"
#include "StraightView.h"
#include "VesselSession.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/Widgets.h>

#include <QKeyEvent>
#include <QLabel>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace insonate::prepare {
namespace {

constexpr double kTurn_deg = 5;

}  // namespace

VesselPanel::VesselPanel(PrepareModel& shared, VesselSession& vessel)
    : shared_(shared),
      vessel_(vessel),
      heading_(ui::paragraph("vesselHeading", "quiet")),
      reason_(ui::paragraph("vesselReason", "quiet")),
      straight_(new StraightView(shared, vessel)),
      sections_(new SectionStrip(shared, vessel)) {
  setObjectName(QStringLiteral("vesselPanel"));
  setFocusPolicy(Qt::StrongFocus);
  reason_->setAlignment(Qt::AlignCenter);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(ui::kSmallGap, 0, ui::kSmallGap, 0);
  box->setSpacing(ui::kSmallGap);
  box->addWidget(heading_);
  box->addWidget(straight_, 1);
  box->addWidget(sections_, 1);
  box->addWidget(reason_, 1);
  connect(&vessel_, &VesselSession::courseChanged, this, [this] { showCourse(); });
  connect(&vessel_, &VesselSession::moved, this, [this] {
    showHeading();
    straight_->update();
    sections_->resample();
  });
  connect(&vessel_, &VesselSession::rotated, straight_, [this] { straight_->resample(); });
  connect(&vessel_, &VesselSession::outlineDragged, sections_, [this] { sections_->update(); });
  const auto redraw = [this] {
    straight_->redraw();
    sections_->redraw();
  };
  connect(&vessel_, &VesselSession::labelsChanged, this, redraw);
  connect(&shared_.slices, &SliceSettings::changed, this, redraw);
  connect(&shared_.appearance, &StructureAppearance::lookChanged, this, redraw);
  showCourse();
}

void VesselPanel::showCourse() {
  const bool isFound = vessel_.course();
  for (QWidget* view :
       {static_cast<QWidget*>(heading_), static_cast<QWidget*>(straight_), static_cast<QWidget*>(sections_)})
    view->setVisible(isFound);
  reason_->setVisible(!isFound);
  reason_->setText(vessel_.reason());
  showHeading();
  sections_->fitCourse();
  straight_->resample();
}

void VesselPanel::showHeading() {
  if (!vessel_.course()) return;
  heading_->setText(tr("%1: drag the outline in the large section. The vessel changes up to %2 mm to both sides.")
                        .arg(shared_.terms.nameOf(vessel_.label()))
                        .arg(vessel_.reach_mm(), 0, 'f', 0));
}

void VesselPanel::wheelEvent(QWheelEvent* event) {
  const QPoint turned = event->angleDelta();
  const int by = turned.y() + turned.x() > 0 ? -1 : 1;
  if (event->modifiers() & Qt::ShiftModifier)
    vessel_.rotate(by * kTurn_deg);
  else
    vessel_.moveTo(int(vessel_.frame()) + by);
  event->accept();
}

void VesselPanel::keyPressEvent(QKeyEvent* event) {
  const bool isBack = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up;
  const bool isOn = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down;
  if (!isBack && !isOn) return QWidget::keyPressEvent(event);
  if (event->modifiers() & Qt::ShiftModifier)
    vessel_.rotate(isBack ? -kTurn_deg : kTurn_deg);
  else
    vessel_.moveTo(int(vessel_.frame()) + (isBack ? -1 : 1));
}

void VesselPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  vessel_.setActive(true);
}

void VesselPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  vessel_.setActive(false);
}

}  // namespace insonate::prepare
