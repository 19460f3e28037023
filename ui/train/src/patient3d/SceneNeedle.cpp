#include "SceneNeedle.h"

#include "../model/CaseModel.h"
#include "../model/HapticControl.h"
#include "../model/StatusLine.h"

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
  Vec3 least = grid.center_mm(), most = least;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 index{corner & 1 ? grid.size[0] - 1.0 : 0, corner & 2 ? grid.size[1] - 1.0 : 0,
                     corner & 4 ? grid.size[2] - 1.0 : 0};
    const Vec3 at = patientFromIndex * index;
    least = {std::min(least.x, at.x), std::min(least.y, at.y), std::min(least.z, at.z)};
    most = {std::max(most.x, at.x), std::max(most.y, at.y), std::max(most.z, at.z)};
  }
  const double side = probe_mm.x < grid.center_mm().x ? 1 : -1;
  const Vec3 at{grid.center_mm().x + side * 0.25 * (most.x - least.x), least.y + 0.35 * (most.y - least.y),
                least.z - kBelow_mm};
  // x to the patient's left, z up from the table.
  return {{{Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}}}, at};
}

}  // namespace

SceneNeedle::SceneNeedle(HapticControl& hands, CaseModel& patientCase, StatusLine& status, views::SceneView& scene,
                         QObject* parent)
    : QObject(parent), hands_(hands), patientCase_(patientCase), status_(status), scene_(scene) {}

std::optional<Transform> SceneNeedle::drawn() const {
  const auto& needle = scene_.needle();
  return needle ? std::optional(needle->patientFromNeedle) : std::nullopt;
}

void SceneNeedle::follow() {
  const auto& held = hands_.needle();
  const auto pose = held ? std::optional(held->patientFromNeedle) : std::nullopt;
  if (sameAsSeen(pose, drawn())) return;
  scene_.setNeedle(pose ? std::optional(views::SceneView::Needle{.patientFromNeedle = *pose, .color = color_})
                        : std::nullopt);
  Q_EMIT changed();
}

void SceneNeedle::setColor(views::Color color) {
  const auto pose = drawn();
  if (std::exchange(color_, color) == color || !pose) return;
  // The needle that is drawn: if it was laid down meanwhile, follow() has to remove it.
  scene_.setNeedle(views::SceneView::Needle{.patientFromNeedle = *pose, .color = color_});
  Q_EMIT changed();
}

void SceneNeedle::setTray(bool isVisible, Vec3 probe_mm) {
  if (isVisible == tray_.has_value()) return;
  tray_ = isVisible ? std::optional(trayBeside(*patientCase_.patient(), probe_mm)) : std::nullopt;
  scene_.setTray(tray_);
}

bool SceneNeedle::isOnTray(Vec3 patient_mm) const {
  if (!tray_) return false;
  const Vec3 at = inverted(*tray_) * patient_mm, half = views::SceneView::kTray_mm * 0.5;
  return std::abs(at.x) < half.x && std::abs(at.y) < half.y && at.z > -kUnderTray_mm && at.z < kOverTray_mm;
}

void SceneNeedle::toggleCut() {
  // Another cut, made in the panel meanwhile, is the user's.
  const auto before = std::exchange(cut_, std::nullopt);
  if (before && *before == scene_.clipping()) return scene_.setClipping({});
  const auto needle = drawn();
  if (!needle || !patientCase_.patient()) return status_.showMessage(tr("Take up the needle first (I)."));
  const Vec3 shaft = needle->linear.column[2], seen = scene_.viewerDirection();
  const Vec3 toward = seen - shaft * dot(seen, shaft);
  if (norm(toward) < 0.1)
    return status_.showMessage(
        tr("You are looking along the needle. Drag beside the patient to turn the view, then press H to cut the "
           "patient open at the needle."));
  views::Clipping cut;
  cut.kind = views::ClippingKind::Free;
  cut.direction = -normalized(toward);
  const Vec3 middle_mm = patientCase_.patient()->ct.geometry.center_mm();
  cut.offset_mm = dot(cut.direction, needle->offset - middle_mm) + kBeforeCut_mm;
  scene_.setClipping(cut);
  cut_ = cut;
  status_.showMessage(
      tr("The anatomy is cut open along the needle. Drag beside the patient to turn the view; H closes the cut."));
}

void SceneNeedle::removeCut() {
  if (std::exchange(cut_, std::nullopt)) scene_.setClipping({});
}

}  // namespace insonate::train
