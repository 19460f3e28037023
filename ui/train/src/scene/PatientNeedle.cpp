// The part of the patient's views that is about the needle, and about what an attempt shows and hides.
#include "../TrainSession.h"
#include "PatientViews.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Theme.h>

#include <QLabel>
#include <QStackedWidget>
#include <utility>

namespace insonate::train {
namespace {

/// The needle lies before the cut, not half in it.
constexpr double kBeforeCut_mm = 1;

}  // namespace

void PatientViews::showNeedle() {
  const auto& held = session_.hands().needle();
  const auto pose = held ? std::optional(held->patientFromNeedle) : std::nullopt;
  if (pose == needle_) return;
  needle_ = pose;
  scene_->setNeedle(pose ? std::optional(views::SceneView::Needle{.patientFromNeedle = *pose, .colour = needleColour_})
                         : std::nullopt);
  scene_->setMoving(true);
  rest_.start();
}

void PatientViews::setNeedleColour(views::Colour colour) {
  if (std::exchange(needleColour_, colour) == colour || !needle_) return;
  needle_.reset();
  showNeedle();
}

void PatientViews::toggleCutAtNeedle() {
  if (std::exchange(needleCut_, false)) return scene_->setClipping({});
  if (!needle_ || !session_.patient()) return session_.say(tr("Take up the needle first (I)."));
  const Vec3 shaft = needle_->linear.column[2], seen = scene_->towardViewer();
  const Vec3 toward = seen - shaft * dot(seen, shaft);
  if (norm(toward) < 0.1)
    return session_.say(tr("The view looks along the needle: drag beside the patient to turn it, then press H."));
  views::Clipping cut;
  cut.kind = views::ClippingKind::Free;
  cut.direction = -normalized(toward);
  const Vec3 middle_mm = session_.patient()->ct.geometry.centre_mm();
  cut.offset_mm = dot(cut.direction, needle_->offset - middle_mm) + kBeforeCut_mm;
  scene_->setClipping(cut);
  needleCut_ = true;
  session_.say(tr("Opened along the needle. Drag beside the patient to turn it; H closes it."));
}

QWidget* PatientViews::buildSilence() {
  auto* words = new QLabel(tr("A test is without the CT."));
  words->setObjectName(QStringLiteral("testWords"));
  words->setAlignment(Qt::AlignCenter);
  ui::setRole(words, "quiet");
  return words;
}

void PatientViews::setSilent(bool silent) {
  if (silent == looksBefore_.has_value()) return;
  below_->setCurrentIndex(silent ? 1 : 0);
  if (silent) {
    if (std::exchange(needleCut_, false)) scene_->setClipping({});
    looksBefore_ = Looks{scene_->opacity(kSkin), scene_->isCtVisible(), {}};
    for (const std::uint8_t label : scene_->structures())
      if (label != kSkin && scene_->isVisible(label)) looksBefore_->shown.push_back(label);
    for (const std::uint8_t label : looksBefore_->shown) scene_->setVisible(label, false);
    scene_->setSkinOpacity(1);
    scene_->setCtVisible(false);
  } else {
    for (const std::uint8_t label : looksBefore_->shown) scene_->setVisible(label, true);
    scene_->setSkinOpacity(looksBefore_->skin);
    scene_->setCtVisible(looksBefore_->ct);
    looksBefore_.reset();
  }
}

}  // namespace insonate::train
