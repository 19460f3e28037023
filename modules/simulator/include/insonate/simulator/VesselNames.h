#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/segmentation/CentreLine.h>
#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Identifies the vessels of a case that share the labels vein and artery, and the target of an attempt. A point
/// belongs to the vessel of CaseManifest::vessels whose wall is nearest, unless the point lies beside that vessel, in
/// an unnamed vessel. In a case without named vessels the targets identify the vessels: the center line of a vein that
/// passes nearest to a target has that target's name.
class VesselNames {
 public:
  /// Makes the names of a case without a target in a vein: each vein counts as the target.
  VesselNames() = default;
  /// Chooses as target the target nearest to `near_mm` (patient space) among those of the procedure; if the case has
  /// none of these, among all.
  VesselNames(const CaseManifest& manifest, const Procedure& procedure, Vec3 near_mm);

  /// Names as in AttemptHeader::vessels.
  std::vector<std::string> names() const;
  /// Number of the vessel with this label at a point of the tissue at rest, as in AttemptEvent::vessel; `veins` are the
  /// center lines of all veins. Neither waits nor allocates.
  std::uint8_t vesselAt(Label label, Vec3 rest_mm, std::span<const CentreLine> veins) const noexcept;
  /// Tells whether a point in a vein (position in tissue at rest) is in the target. Neither waits nor allocates.
  bool isTarget(Vec3 rest_mm, std::span<const CentreLine> veins) const noexcept {
    return targets_.empty() || vesselAt(kVein, rest_mm, veins) == 1;
  }
  /// Distance from a point of the tissue at rest to the center line of the target; if the case has no target, to the
  /// nearest of all center lines. Empty if there is no line. Neither waits nor allocates.
  std::optional<double> distanceToCentre_mm(Vec3 rest_mm, std::span<const CentreLine> veins) const noexcept;

 private:
  std::vector<Target> targets_;       ///< targets in veins; the target of the attempt first
  std::vector<NamedVessel> vessels_;  ///< the target first; empty: the case names no vessels
};

}  // namespace insonate
