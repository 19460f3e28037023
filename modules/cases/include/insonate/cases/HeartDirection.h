#pragma once

#include <insonate/cases/PatientCase.h>

#include <optional>
#include <span>

namespace insonate {

/// Tells whether the first point of a vessel's center line is nearer to the heart, along the vessels, than the last
/// one. The name decides if it is known. Otherwise an end that lies in a larger vessel with the same label is the
/// nearer one, since vessels branch away from the heart; otherwise the caudal end or, in a level vessel, the end nearer
/// to the middle of `all`. `vessel` may be one of `all`. Patient LPS.
bool beginsAtHeart(const NamedVessel& vessel, std::span<const NamedVessel> all);

/// Returns the unit direction toward the heart of the named vein whose center line passes nearest to a point, there.
/// In a case without named veins, the name of the nearest target in a vein tells the direction, along an axis of the
/// body. Empty if neither is known. Patient LPS.
std::optional<Vec3> veinTowardHeart(const CaseManifest& manifest, Vec3 near_mm);

}  // namespace insonate
