#pragma once

#include "RegionModel.h"

#include <string>

namespace insonate::phantom {

/// Everything from which a built-in case is made. Positions are in patient mm.
struct Region {
  RegionModel model;
  VolumeGeometry grid;
  std::vector<Target> targets{};
  std::vector<StartPose> startPoses{};  ///< training begins at the first one
  std::vector<Landmark> landmarks{};
  OwnLabels ownLabels{};  ///< structures that the label table does not contain
};

/// Returns a landmark at each transverse start pose: a puncture site.
std::vector<Landmark> punctureSites(const std::vector<StartPose>& poses);

}  // namespace insonate::phantom
