#pragma once

#include <insonate/views/Theme.h>

#include <cstdint>

namespace insonate::views {

enum class ColourScheme {
  Usual,            ///< colors of the label table, as in other programs
  ColourBlindSafe,  ///< can also be distinguished by people without red or green cones
};

/// Returns the color of a label; the color of soft tissue for an unknown label.
Colour labelColour(std::uint8_t label, ColourScheme scheme);

/// Default opacity of a structure's surface, 0 to 1; the skin is translucent.
double defaultOpacity(std::uint8_t label);

}  // namespace insonate::views
