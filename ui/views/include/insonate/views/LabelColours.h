#pragma once

#include <insonate/views/Theme.h>

#include <cstdint>

namespace insonate::views {

enum class ColourScheme {
  Usual,            ///< colors of the label table, as in other programs
  ColourBlindSafe,  ///< colors that people with red-green color blindness can also distinguish
};

/// Returns the color of a label; the color of soft tissue for an unknown label.
Colour labelColour(std::uint8_t label, ColourScheme scheme);

/// Returns the default opacity of a structure's surface, 0 to 1; only the skin's opacity is below 1.
double defaultOpacity(std::uint8_t label);

}  // namespace insonate::views
