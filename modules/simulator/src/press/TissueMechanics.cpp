#include <insonate/core/Range.h>
#include <insonate/simulator/TissueMechanics.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

/// ProbePlacement limits the indentation; the remainder is a margin for rounding.
constexpr double kAbove_mm = 22;
/// Beside the face tissue is displaced; farther away it hardly moves.
constexpr double kBeside_mm = 8;
/// Bone and vessels below a shallow image affect the tissue in it.
constexpr double kMinDepth_mm = 40;
/// A wider arc would turn back at its ends.
constexpr double kMaxHalfArc_rad = 85 * std::numbers::pi / 180;

}  // namespace

const MechanicalTable& measuredMechanics() {
  static const MechanicalTable table = loadMechanicalTable("measured").value();
  return table;
}

bool operator==(const TissueMechanics& a, const TissueMechanics& b) {
  return a.model == b.model && a.tissues.tissues == b.tissues.tissues && a.footprint_mm == b.footprint_mm &&
         a.sticking == b.sticking && a.settings.mesh_mm == b.settings.mesh_mm &&
         a.settings.depth_mm == b.settings.depth_mm && a.settings.maxIterations == b.settings.maxIterations &&
         a.settings.tolerance_mm == b.settings.tolerance_mm;
}

Result<void> validate(const TissueMechanics& mechanics) {
  if (auto ok = checkRange(mechanics.footprint_mm, 1, 100, "Deformation: footprint_mm"); !ok) return ok;
  if (mechanics.model == kNoDeformation) return {};
  auto model = makeDeformationModel(mechanics.model, mechanics.tissues, mechanics.settings);
  if (!model) return tl::unexpected(model.error());
  return {};
}

ProbeFace probeFaceOf(const Probe& probe, const TissueMechanics& mechanics) {
  ProbeFace face;
  face.footprint_mm = mechanics.footprint_mm;
  face.sticking = mechanics.sticking;
  switch (probe.shape) {
    case ProbeShape::Linear:
      face.width_mm = probe.width_mm + 2 * probe.faceMargin_mm;
      break;
    case ProbeShape::Curvilinear: {
      const double half_rad = probe.fovAngle_deg * std::numbers::pi / 360 + probe.faceMargin_mm / probe.faceRadius_mm;
      face.radius_mm = probe.faceRadius_mm;
      face.width_mm = 2 * probe.faceRadius_mm * std::sin(std::min(half_rad, kMaxHalfArc_rad));
      break;
    }
    case ProbeShape::Phased:
      face.width_mm = probe.maxAperture_mm + 2 * probe.faceMargin_mm;
      break;
  }
  face.width_mm = std::max(face.width_mm, 1.0);
  return face;
}

DeformationWindow deformationWindow(const Probe& probe, const ImagingSettings& settings,
                                    const TissueMechanics& mechanics) {
  const BeamGrid grid(probe, settings);
  return {probeFaceOf(probe, mechanics).width_mm / 2 + kBeside_mm, -kAbove_mm,
          std::max(grid.maxAxial_mm(), kMinDepth_mm)};
}

}  // namespace insonate
