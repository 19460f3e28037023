#pragma once

#include "../places/CasePlaces.h"

#include <insonate/views/NamedPlace.h>
#include <insonate/views/SceneOptions.h>

namespace insonate::prepare {

/// The author's places, as they are drawn.
struct MarkedPlaces {
  std::vector<views::NamedPlace> places;  ///< on slices, with their names
  std::vector<views::ScenePath> paths;    ///< in 3D: crosses, and of a start pose the probe's face and the way it looks
};

MarkedPlaces markedPlaces(const CasePlaces& places);

/// A cross in 3D, of three lines.
void addCross(std::vector<views::ScenePath>& paths, Vec3 at_mm, views::Colour colour);

}  // namespace insonate::prepare
