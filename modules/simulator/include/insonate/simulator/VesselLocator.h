#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/segmentation/CenterLine.h>
#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Determines which vessel is at a point of a case, and which vessel is the target of an attempt. (All veins of a case
/// have the same label, and so have all arteries.) A point belongs to the vessel of CaseManifest::vessels whose wall is
/// nearest. If the point lies outside the wall of this vessel, in a vessel without a name, it belongs to the vessel
/// without a name. In a case without named vessels, the vein whose center line passes nearest to a target of the case
/// gets the name of the target.
class VesselLocator {
 public:
  /// Makes an object for a case without a target in a vein; every vein then counts as the target.
  VesselLocator() = default;
  /// Chooses the target of the attempt: of the case's targets that the procedure allows, the one nearest to `near_mm`
  /// (patient space). If the procedure allows none of them, the nearest of all targets is used.
  VesselLocator(const CaseManifest& manifest, const Procedure& procedure, Vec3 near_mm);

  /// Returns the vessel names in the form of AttemptHeader::vessels: the target first.
  std::vector<std::string> names() const;
  /// Returns the number (AttemptEvent::vessel) of the vessel with this label at a point of the undeformed tissue;
  /// `veins` are the center lines of all veins. Neither waits nor allocates.
  std::uint8_t vesselAt(Label label, Vec3 rest_mm, std::span<const CenterLine> veins) const noexcept;
  /// Tells whether a point in a vein (position in undeformed tissue) is in the target vein. Neither waits nor
  /// allocates.
  bool isTarget(Vec3 rest_mm, std::span<const CenterLine> veins) const noexcept {
    return targets_.empty() || vesselAt(kVein, rest_mm, veins) == 1;
  }
  /// Returns the distance from a point of the undeformed tissue to the center line of a vein (`vessel`:
  /// AttemptEvent::vessel; 1 is the target); without a target, to the nearest center line. Empty if there is no center
  /// line. Neither waits nor allocates.
  std::optional<double> distanceToCenterLine_mm(Vec3 rest_mm, std::span<const CenterLine> veins,
                                                std::uint8_t vessel = 1) const noexcept;

 private:
  std::vector<Target> targets_;       ///< the case's targets that lie in veins; the target of the attempt first
  std::vector<NamedVessel> vessels_;  ///< the case's named vessels, the target first; empty: the case names none
};

}  // namespace insonate
