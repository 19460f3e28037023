#pragma once

#include <insonate/cases/PatientCase.h>

#include <array>
#include <vector>

namespace insonate::wire {

/// Symmetric tensor M of an elliptic cross-section: x M x = 1 on the wall, for x from the center. Components xx, yy,
/// zz, xy, xz, yz in patient space; along the vessel it is that of a circle with the mean radius.
using Section = std::array<double, 6>;

Section roundSection(double radius_mm);

/// Measures the lumen of a vessel in a label map by rays from its course. Moves the points of the course to the centers
/// of the lumen, sets their radii to the mean, and returns a cross-section for each point. Points outside of the lumen
/// of the label map keep position and radius.
std::vector<Section> measuredSections(NamedVessel& vessel, const LabelMap& labels);

}  // namespace insonate::wire
