#pragma once

#include "../model/CasePlaces.h"

#include <insonate/views/NamedPoint.h>
#include <insonate/views/SceneOptions.h>

namespace insonate::prepare {

/// The author's places (targets, landmarks, start poses) in the form in which views draw them.
struct MarkedPlaces {
  std::vector<views::NamedPoint> places;  ///< points on slices, with their names
  /// Lines in 3D: crosses and, for a start pose, the probe's face and its viewing direction.
  std::vector<views::ScenePath> paths;
};

MarkedPlaces markedPlaces(const CasePlaces& places);

/// Adds a cross of three lines in 3D.
void addCross(std::vector<views::ScenePath>& paths, Vec3 at_mm, views::Color color);

}  // namespace insonate::prepare
