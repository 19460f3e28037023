#pragma once

#include <cstdint>

namespace insonate::views {

/// sRGB color, components 0 to 255.
struct Color {
  std::uint8_t red = 0, green = 0, blue = 0;
  constexpr bool operator==(const Color&) const = default;
};

/// Colors of the window.
namespace theme {
inline constexpr Color kGround{0x14, 0x17, 0x1a};
inline constexpr Color kPanel{0x1b, 0x1f, 0x24};
inline constexpr Color kRaised{0x24, 0x2a, 0x31};
inline constexpr Color kLine{0x32, 0x3a, 0x43};
inline constexpr Color kText{0xd9, 0xdf, 0xe5};
/// Gray for less important text; contrast 7:1 or more on all backgrounds of text.
inline constexpr Color kQuiet{0xb0, 0xba, 0xc3};
inline constexpr Color kAccent{0x4a, 0xa3, 0xd8};
/// Accent color for text.
inline constexpr Color kLink{0x86, 0xc8, 0xf0};
inline constexpr Color kGood{0x4c, 0xaf, 0x7d};
inline constexpr Color kCaution{0xe0, 0xa3, 0x3a};
inline constexpr Color kDanger{0xe0, 0x5a, 0x52};
inline constexpr Color kWire{0xf2, 0xf2, 0xe6};
inline constexpr Color kCatheter{0x5c, 0x9d, 0xff};
inline constexpr Color kBlack{0, 0, 0};
}  // namespace theme

}  // namespace insonate::views
