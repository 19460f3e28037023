#include "ClippingControls.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace insonate::ui {
namespace {

constexpr double kDegrees = 180 / 3.14159265358979;

struct Kind {
  views::ClippingKind kind;
  const char* name;
};
constexpr Kind kKinds[] = {
    {views::ClippingKind::Off, "nothing"},
    {views::ClippingKind::Axial, "axial: below the plane"},
    {views::ClippingKind::Coronal, "coronal: in front of the plane"},
    {views::ClippingKind::Sagittal, "sagittal: right of the plane"},
    {views::ClippingKind::ImagePlane, "one side of the image plane"},
    {views::ClippingKind::Free, "one side of any plane"},
};

/// Turned from the front toward the patient's left, then tilted up.
Vec3 directionOf(double turn_deg, double tilt_deg) {
  const double turn = turn_deg / kDegrees, tilt = tilt_deg / kDegrees;
  return {std::cos(tilt) * std::sin(turn), -std::cos(tilt) * std::cos(turn), std::sin(tilt)};
}

}  // namespace

ClippingControls::ClippingControls(std::shared_ptr<views::SceneView> scene, QWidget* parent)
    : QWidget(parent),
      scene_(std::move(scene)),
      kind_(new QComboBox),
      offset_(new ValueSlider(tr("position"), tr("mm"), {-100, 100, 0, 1, 0},
                              tr("Distance of the plane from the patient's middle or from the image plane"))),
      turn_(new ValueSlider(tr("turn"), tr("°"), {-180, 180, 0, 5, 0},
                            tr("Direction of the plane: 0° keeps the front of the patient, 90° keeps the left side"))),
      tilt_(new ValueSlider(tr("tilt"), tr("°"), {-90, 90, 0, 5, 0},
                            tr("Tilt of the plane: 90° keeps the side toward the head"))),
      flipped_(new QCheckBox(tr("Flip"))),
      asSeen_(new QToolButton) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(kSmallGap);
  auto* row = new QHBoxLayout;
  auto* name = new QLabel(tr("clipped"));
  setRole(name, "quiet");
  kind_->setObjectName(QStringLiteral("clippingKind"));
  kind_->setAccessibleName(tr("Clipping plane"));
  kind_->setToolTip(tr("Clips surfaces and CT at a plane; probe and image are not clipped"));
  for (const Kind& kind : kKinds) kind_->addItem(tr(kind.name), int(kind.kind));
  kind_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  kind_->setMinimumContentsLength(8);
  row->addWidget(name);
  row->addWidget(kind_, 1);
  box->addLayout(row);
  offset_->setObjectName(QStringLiteral("clippingOffset"));
  turn_->setObjectName(QStringLiteral("clippingTurn"));
  tilt_->setObjectName(QStringLiteral("clippingTilt"));
  flipped_->setObjectName(QStringLiteral("clippingFlipped"));
  flipped_->setToolTip(tr("Exchanges the clipped side and the visible side of the plane"));
  asSeen_->setText(tr("Turn plane to viewer"));
  asSeen_->setObjectName(QStringLiteral("clippingAsSeen"));
  asSeen_->setToolTip(tr("Turns the plane toward you and clips everything in front of the plane"));
  for (QWidget* part : {static_cast<QWidget*>(offset_), static_cast<QWidget*>(turn_), static_cast<QWidget*>(tilt_)})
    box->addWidget(part);
  auto* last = new QHBoxLayout;
  last->addWidget(flipped_);
  last->addStretch();
  last->addWidget(asSeen_);
  box->addLayout(last);
  connect(kind_, qOverload<int>(&QComboBox::activated), this, [this] {
    // A plane of another kind starts in the middle.
    refreshing_ = true;
    offset_->setValue(0);
    refreshing_ = false;
    apply();
  });
  for (ValueSlider* slider : {offset_, turn_, tilt_})
    connect(slider, &ValueSlider::valueChanged, this, &ClippingControls::apply);
  connect(flipped_, &QCheckBox::clicked, this, &ClippingControls::apply);
  connect(asSeen_, &QToolButton::clicked, this, &ClippingControls::takeView);
  refresh();
}

void ClippingControls::refresh() {
  refreshing_ = true;
  const views::Clipping& clipping = scene_->clipping();
  kind_->setCurrentIndex(kind_->findData(int(clipping.kind)));
  const bool on = clipping.kind != views::ClippingKind::Off, free = clipping.kind == views::ClippingKind::Free;
  const double reach = std::max(1.0, std::ceil(scene_->maxClippingOffset_mm(clipping)));
  offset_->setRange({-reach, reach, 0, 1, 0});
  offset_->setValue(clipping.offset_mm);
  flipped_->setChecked(clipping.flipped);
  const Vec3 direction = clipping.direction;
  if (free && norm(direction) > 0) {
    const Vec3 unit = normalized(direction);
    tilt_->setValue(std::asin(std::clamp(unit.z, -1.0, 1.0)) * kDegrees);
    if (std::hypot(unit.x, unit.y) > 1e-3) turn_->setValue(std::atan2(unit.x, -unit.y) * kDegrees);
  }
  offset_->setVisible(on);
  flipped_->setVisible(on);
  for (QWidget* part : {static_cast<QWidget*>(turn_), static_cast<QWidget*>(tilt_), static_cast<QWidget*>(asSeen_)})
    part->setVisible(free);
  refreshing_ = false;
}

void ClippingControls::apply() {
  if (refreshing_) return;
  views::Clipping clipping;
  clipping.kind = views::ClippingKind(kind_->currentData().toInt());
  clipping.offset_mm = offset_->value();
  clipping.flipped = flipped_->isChecked();
  clipping.direction = directionOf(turn_->value(), tilt_->value());
  scene_->setClipping(clipping);
  refresh();
  Q_EMIT changed();
}

void ClippingControls::takeView() {
  views::Clipping clipping = scene_->clipping();
  clipping.direction = -scene_->viewerDirection();
  clipping.flipped = false;
  scene_->setClipping(clipping);
  refresh();
  Q_EMIT changed();
}

}  // namespace insonate::ui
