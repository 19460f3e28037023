#pragma once

#include <insonate/views/Theme.h>

#include <cstdint>

namespace insonate::views {

enum class ColorScheme {
  Default,         ///< colors of the label table, as in other programs
  ColorBlindSafe,  ///< colors that people with red-green color blindness can also distinguish
};

/// Returns the color of a label; the color of soft tissue for an unknown label.
Color labelColor(std::uint8_t label, ColorScheme scheme);

/// Returns the default opacity of a structure's surface, 0 to 1; only the skin's opacity is below 1.
double defaultOpacity(std::uint8_t label);

}  // namespace insonate::views
