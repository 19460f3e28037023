#pragma once

#include <insonate/cases/PatientCase.h>

#include <span>
#include <vector>

namespace insonate {

/// Returns for each vessel the smallest open area of the lumen through which its blood flows from or to the heart,
/// relative to the area by its radius, 0 to 1. A part of a lumen is filled, e.g. by a thrombus, where the label map has
/// another label between two open parts: along the center line, or between the end of the vessel nearer to the heart
/// and a vessel that continues it. Vessels that join a filled part have its open area. `beginsAtHeart` tells for each
/// vessel whether the first point of the center line is nearer to the heart.
std::vector<double> openLumens(std::span<const NamedVessel> vessels, const std::vector<bool>& beginsAtHeart,
                               const LabelMap& labels);

}  // namespace insonate
