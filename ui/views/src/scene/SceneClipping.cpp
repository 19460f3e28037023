#include "PatientBox.h"
#include "SceneDrawing.h"

#include <cmath>

namespace insonate::views {
namespace {

/// Clipping planes fixed in the patient.
Vec3 normalOf(const Clipping& clipping) {
  switch (clipping.kind) {
    case ClippingKind::Coronal:
      return {0, 1, 0};
    case ClippingKind::Sagittal:
      return {1, 0, 0};
    case ClippingKind::Free:
      if (norm(clipping.direction) > 1e-6) return normalized(clipping.direction);
      break;
    default:
      break;
  }
  return {0, 0, 1};
}

struct Box {
  Vec3 middle, half;
};

/// Extent of clipping: the CT, because surfaces arrive one after the other; without a case, the surfaces.
Box boxOf(const VtkCase* patient, const SceneState& state) {
  double box[6] = {};
  if (patient)
    ctBox(*patient, box);
  else if (!patientBox(state, nullptr, box))
    return {};
  const Vec3 low{box[0], box[2], box[4]}, high{box[1], box[3], box[5]};
  return {(low + high) * 0.5, (high - low) * 0.5};
}

}  // namespace

void SceneView::setClipping(const Clipping& clipping) {
  drawing_->clipping = clipping;
  clip();
}

const Clipping& SceneView::clipping() const {
  return drawing_->clipping;
}

std::optional<ClippingPlane> SceneView::clippingPlane() const {
  const Clipping& clipping = drawing_->clipping;
  if (clipping.kind == ClippingKind::Off) return std::nullopt;
  const bool ofProbe = clipping.kind == ClippingKind::ImagePlane;
  if (ofProbe && !drawing_->state.probe) return std::nullopt;
  const Transform& pose = drawing_->state.patientFromProbe;
  const Vec3 normal = ofProbe ? pose.linear.column[1] : normalOf(clipping);
  const Vec3 from = ofProbe ? pose.offset : boxOf(drawing_->patient.get(), drawing_->state).middle;
  return ClippingPlane{from + normal * clipping.offset_mm, clipping.flipped ? -normal : normal};
}

double SceneView::maxClippingOffset_mm(const Clipping& clipping) const {
  const Vec3 half = boxOf(drawing_->patient.get(), drawing_->state).half;
  if (clipping.kind == ClippingKind::ImagePlane) return norm(half);
  const Vec3 normal = normalOf(clipping);
  return std::abs(normal.x) * half.x + std::abs(normal.y) * half.y + std::abs(normal.z) * half.z;
}

void SceneView::clip() {
  drawing_->state.cut = clippingPlane();
  changed();
}

}  // namespace insonate::views
