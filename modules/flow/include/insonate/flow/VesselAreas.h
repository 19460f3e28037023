#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>

#include <span>
#include <vector>

namespace insonate {

/// Area of each vessel's lumen at the points of its center line, relative to the area in the CT, [vessel][point].
using VesselAreas = std::vector<std::vector<double>>;

/// Area factor at which a compressed lumen counts as closed. The mechanical model keeps the walls of a closed vein
/// apart, so that its area never becomes 0 (see deformation/README.md).
inline constexpr double kClosedArea = 0.12;

/// Computes the areas of the vessels that a displacement of the image plane changes: the area of the displayed tissue
/// within the vessel, divided by the area of the same tissue in the CT. Where a vessel runs along the plane, this is
/// the ratio of its heights. The factors of points beside the plane return to 1 over 30 mm. Allocates nothing if
/// `areas` has been used with the same vessels before.
void computeVesselAreas(std::span<const NamedVessel> vessels, const PlaneDisplacement& displacement,
                        const Transform& patientFromProbe, VesselAreas& areas);

}  // namespace insonate
