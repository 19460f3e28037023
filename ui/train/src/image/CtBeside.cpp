#include "CtBeside.h"

#include "../model/CaseModel.h"
#include "../model/LiveModel.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <algorithm>

namespace insonate::train {
namespace {

/// Share of the window's time; the rest is the image's.
constexpr double kBesideShare = 0.25;
constexpr int kBesideSoonest_ms = 33, kBesideLatest_ms = 400;

}  // namespace

CtBeside::CtBeside(CaseModel& patientCase, LiveModel& live, QWidget* parent)
    : QObject(parent),
      patientCase_(patientCase),
      live_(live),
      view_(std::make_shared<views::MprView>(views::SliceKind::Oblique)),
      widget_(new ui::ViewWidget(view_, tr("CT in the plane of the image"), parent)) {
  widget_->setObjectName(QStringLiteral("ctBeside"));
  widget_->setMaximizeOnDoubleClick(false);
  widget_->hide();
  view_->setCrosshairVisible(false);
  view_->setLabelOutlines(true);
  // Tissue that fills the space between structures has no useful outline.
  for (const std::uint8_t label : {kSkin, kFat, kSoftTissue}) view_->setLabelVisible(label, false);
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, [this] { follow(); });
  connect(&patientCase_, &CaseModel::caseChanged, this, [this] { showCase(); });
  connect(&patientCase_, &CaseModel::tissuesKnown, this, [this] { showCase(); });
  connect(&live_, &LiveModel::pictureShown, this, [this] { want(); });
}

void CtBeside::setShown(bool shown) {
  shown_ = shown;
  showCase();
}

void CtBeside::showCase() {
  timer_.stop();
  shape_ = nullptr;
  const bool there = shown_ && patientCase_.patient();
  // The labels are known before the first image.
  std::shared_ptr<views::VtkCase> tissues;
  if (there && patientCase_.tissueLabels()) {
    tissues = std::make_shared<views::VtkCase>(patientCase_.patient());
    tissues->setLabels(patientCase_.tissueLabels());
  }
  view_->setCase(tissues);
  view_->setAlignedImage(std::nullopt);
  widget_->setVisible(there);
  if (there) follow();
}

void CtBeside::want() {
  if (!shown_ || timer_.isActive()) return;
  const double cost_ms = 1000 * view_->renderer()->GetLastRenderTimeInSeconds();
  const int gap_ms = std::clamp(int(cost_ms / kBesideShare), kBesideSoonest_ms, kBesideLatest_ms);
  const int since_ms =
      sinceFollowed_.isValid() ? int(std::min<qint64>(sinceFollowed_.elapsed(), kBesideLatest_ms)) : kBesideLatest_ms;
  timer_.start(std::max(0, gap_ms - since_ms));
}

void CtBeside::follow() {
  sinceFollowed_.start();
  const auto& frame = live_.shown();
  if (!frame) return;
  view_->setProbePose(frame->patientFromProbe);
  if (frame->setup == shape_) return;
  shape_ = frame->setup;
  const BeamGrid grid(shape_->probe, shape_->settings);
  view_->setFan(shape_->probe, shape_->settings);
  view_->setAlignedImage(
      views::ImageBounds{grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()});
}

}  // namespace insonate::train
