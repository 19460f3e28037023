// The part of the patient's views that is about the needle, and about what an attempt shows and hides.
#include "../model/TrainModel.h"
#include "PatientViews.h"
#include "SceneInput.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ui/Theme.h>

#include <QLabel>
#include <QStackedWidget>
#include <algorithm>
#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

/// The needle lies before the cut, not half in it.
constexpr double kBeforeCut_mm = 1;
/// Less is no motion: a hand comes to rest little by little, and 3D is drawn coarser while something moves.
constexpr double kStill_mm = 0.02, kStill_rad = 0.0005;

bool sameAsSeen(const std::optional<Transform>& a, const std::optional<Transform>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  double turn = 0;
  for (int i = 0; i < 3; ++i) turn = std::max(turn, norm(a->linear.column[i] - b->linear.column[i]));
  return norm(a->offset - b->offset) < kStill_mm && turn < kStill_rad;
}

constexpr double kUnderTray_mm = 10, kOverTray_mm = 25;
/// From the scan's lower edge, toward the feet.
constexpr double kBelow_mm = 35;

/// Across the chest on the side that is not worked on, as high as the scan's front.
Transform trayBeside(const PatientCase& patient, Vec3 probe_mm) {
  const VolumeGeometry& grid = patient.labels.geometry;
  const Transform patientFromIndex = grid.patientFromIndex();
  Vec3 least = grid.centre_mm(), most = least;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 index{corner & 1 ? grid.size[0] - 1.0 : 0, corner & 2 ? grid.size[1] - 1.0 : 0,
                     corner & 4 ? grid.size[2] - 1.0 : 0};
    const Vec3 at = patientFromIndex * index;
    least = {std::min(least.x, at.x), std::min(least.y, at.y), std::min(least.z, at.z)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y), std::max(most.z, at.z)};
  }
  const double side = probe_mm.x < grid.centre_mm().x ? 1 : -1;
  const Vec3 at{grid.centre_mm().x + side * 0.25 * (most.x - least.x), least.y + 0.35 * (most.y - least.y),
                least.z - kBelow_mm};
  // x to the patient's left, z up from the table.
  return {{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}}}, at};
}

}  // namespace

void PatientViews::showNeedle() {
  const auto& held = model_.hands.needle();
  const auto pose = held ? std::optional(held->patientFromNeedle) : std::nullopt;
  if (sameAsSeen(pose, needle_)) return;
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

void PatientViews::turn(double across_deg, double up_deg) {
  scene_->orbit(across_deg, up_deg);
  scene_->setMoving(true);
  rest_.start();
}

void PatientViews::setTrayVisible(bool visible) {
  if (visible == tray_.has_value()) return;
  tray_ = visible ? std::optional(trayBeside(*model_.patientCase.patient(), poseNow().offset)) : std::nullopt;
  input_->setTray(tray_);
  scene_->setTray(tray_);
}

bool PatientViews::isOnTray(Vec3 patient_mm) const {
  if (!tray_) return false;
  const Vec3 at = inverted(*tray_) * patient_mm, half = views::SceneView::kTray_mm * 0.5;
  return std::abs(at.x) < half.x && std::abs(at.y) < half.y && at.z > -kUnderTray_mm && at.z < kOverTray_mm;
}

void PatientViews::setTrayTaken(std::function<void()> listener) {
  input_->setTrayTaken(std::move(listener));
}

void PatientViews::toggleCutAtNeedle() {
  // Another cut, made in the panel meanwhile, is the user's.
  const auto before = std::exchange(needleCut_, std::nullopt);
  if (before && *before == scene_->clipping()) return scene_->setClipping({});
  if (!needle_ || !model_.patientCase.patient()) return model_.status.say(tr("Take up the needle first (I)."));
  const Vec3 shaft = needle_->linear.column[2], seen = scene_->towardViewer();
  const Vec3 toward = seen - shaft * dot(seen, shaft);
  if (norm(toward) < 0.1)
    return model_.status.say(tr("The view looks along the needle: drag beside the patient to turn it, then press H."));
  views::Clipping cut;
  cut.kind = views::ClippingKind::Free;
  cut.direction = -normalized(toward);
  const Vec3 middle_mm = model_.patientCase.patient()->ct.geometry.centre_mm();
  cut.offset_mm = dot(cut.direction, needle_->offset - middle_mm) + kBeforeCut_mm;
  scene_->setClipping(cut);
  needleCut_ = cut;
  model_.status.say(tr("Opened along the needle. Drag beside the patient to turn it; H closes it."));
}

QWidget* PatientViews::buildSilence() {
  auto* words = new QLabel(tr("A test shows neither CT nor anatomy."));
  words->setObjectName(QStringLiteral("testWords"));
  words->setAlignment(Qt::AlignCenter);
  ui::setRole(words, "quiet");
  return words;
}

void PatientViews::applyDisclosure() {
  const bool hidden = !model_.disclosure.current().anatomy;
  if (hidden == looksBefore_.has_value()) return;
  below_->setCurrentIndex(hidden ? 1 : 0);
  if (hidden) {
    if (std::exchange(needleCut_, std::nullopt)) scene_->setClipping({});
    looksBefore_ = Looks{scene_->opacity(kSkin), scene_->isCtVisible(), {}, scene_->clipping()};
    // Also those whose surface is still being made.
    for (const LabelInfo& info : labelTable())
      if (info.label != kSkin && scene_->isVisible(info.label)) looksBefore_->shown.push_back(info.label);
    for (const std::uint8_t label : looksBefore_->shown) scene_->setVisible(label, false);
    scene_->setSkinOpacity(1);
    scene_->setCtVisible(false);
    scene_->setClipping({});
  } else {
    for (const std::uint8_t label : looksBefore_->shown) scene_->setVisible(label, true);
    scene_->setSkinOpacity(looksBefore_->skin);
    scene_->setCtVisible(looksBefore_->ct);
    scene_->setClipping(looksBefore_->clipping);
    looksBefore_.reset();
  }
}

}  // namespace insonate::train
