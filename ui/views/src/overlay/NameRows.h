#pragma once

#include <insonate/views/Input.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace insonate::views {

/// Finds positions for names beside marks so that no name covers another. Names are placed in rows above each other; if
/// too many marks are close together, a name gets no position. The first name is in the row of its mark. A long name is
/// shortened, so that it crosses neither the image nor the image's edge. Positions are in logical or in device pixels.
class NameRows {
 public:
  NameRows(double width_px, double size_px) : width_px_(width_px), size_px_(size_px) {}

  struct Place {
    DisplayPoint at;      ///< end of the name nearer to its mark, at half the name's height
    bool before;          ///< the name is to the left of the mark, since there is not enough space to the right
    std::size_t letters;  ///< number of letters that fit
  };

  /// Returns the place for a name; empty if there is no space.
  std::optional<Place> put(DisplayPoint mark, std::size_t letters) {
    constexpr double kLetter = 0.58, kRow = 1.25, kGap = 0.85;  // in units of the font size
    constexpr double kShare = 0.4;                              // maximum fraction of the view's width for one name
    constexpr double kFewest = 4;                               // minimum number of letters
    const double letter = kLetter * size_px_, gap = kGap * size_px_;
    const double wanted = std::min(letter * double(letters), std::max(kShare * width_px_, kFewest * letter));
    const double behind = width_px_ - mark.x - gap, ahead = mark.x - gap;
    const bool before = behind < wanted && ahead > behind;
    const double length = std::min(wanted, before ? ahead : behind);
    const auto fitting = std::min(letters, std::size_t(std::max(0.0, length / letter + 1e-9)));
    if (double(fitting) < std::min(kFewest, double(letters))) return std::nullopt;
    for (const int row : {0, 1, -1, 2, -2}) {
      const DisplayPoint at{before ? mark.x - gap : mark.x + gap, mark.y + row * kRow * size_px_};
      const Name name{before ? at.x - length : at.x, before ? at.x : at.x + length, at.y};
      if (covers(name, kRow * size_px_)) continue;
      taken_.push_back(name);
      return Place{at, before, fitting};
    }
    return std::nullopt;
  }

 private:
  struct Name {
    double left, right, y;
  };
  bool covers(const Name& name, double row) const {
    return std::ranges::any_of(taken_, [&](const Name& other) {
      return std::abs(other.y - name.y) < 0.99 * row && name.left < other.right && other.left < name.right;
    });
  }

  double width_px_, size_px_;
  std::vector<Name> taken_;
};

}  // namespace insonate::views
