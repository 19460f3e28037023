#pragma once

#include <insonate/views/Theme.h>

#include <cstdint>

namespace insonate::views {

enum class ColourScheme {
  Usual,            ///< the label table's: those of other programs
  ColourBlindSafe,  ///< apart for eyes without red or green cones, too
};

/// A label that is not known has soft tissue's colour.
Colour labelColour(std::uint8_t label, ColourScheme scheme);

/// Default opacity of a structure's surface, 0..1: the skin is translucent.
double defaultOpacity(std::uint8_t label);

}  // namespace insonate::views
