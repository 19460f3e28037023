#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/segmentation/CentreLine.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Tells the target vein of an attempt from the other veins of the case, which share its label. A vein is known by its
/// center line: the one that passes nearest to a target of the case bears that target's name.
class TargetVein {
 public:
  /// A case without a target in a vein: each vein counts as the target.
  TargetVein() = default;
  /// The target is the one nearest to `near_mm` (patient space) among those the procedure is for, or among all where
  /// the case names none of them.
  TargetVein(const CaseManifest& manifest, const Procedure& procedure, Vec3 near_mm);

  /// As in AttemptHeader::vessels.
  std::vector<std::string> names() const;
  /// Vein at a point of the tissue at rest, as in AttemptEvent::vessel; `veins` are the center lines of all veins.
  /// Neither waits nor allocates.
  std::uint8_t vesselAt(Vec3 rest_mm, std::span<const CentreLine> veins) const noexcept;
  /// Distance from a point of the tissue at rest to the target's center line; to the nearest of all lines where the
  /// case has no target. None where there is no line. Neither waits nor allocates.
  std::optional<double> distanceToCentre_mm(Vec3 rest_mm, std::span<const CentreLine> veins) const noexcept;

 private:
  std::vector<Target> named_;  ///< in veins; the target of the attempt first
};

}  // namespace insonate
