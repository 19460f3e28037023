#pragma once

#include <insonate/tissue/MechanicalTable.h>

#include <array>

namespace insonate::column {

/// Maximum shortening of a spring, as a share of its length, so that tissue does not fold. Only reached if the linear
/// law of the springs would compress tissue to almost zero length.
inline constexpr double kMaxShortening = 0.9;

/// Young's modulus of a lumen in a column, kPa: Table I of the thesis. A soft spring replaces the lumen, because a
/// spring cannot be emptied and filled like a vessel.
inline constexpr double kArteryLumen_kPa = 200, kVeinLumen_kPa = 23;

/// Total length of each label in a column, mm.
using LengthByLabel = std::array<double, kLabelCount>;

struct ColumnLoad {
  double pressure_kPa = 0;  ///< pressure, the same in all springs of a column
  double shortening_mm = 0;
  bool limited = false;  ///< true if the column was shortened less than requested, since all springs are rigid or at
                         ///< kMaxShortening
};

/// Springs in series, by label. The compliance of a label is 1 / E in 1/kPa, which is exactly 0 for an infinite
/// modulus.
class LabelSprings {
 public:
  explicit LabelSprings(const MechanicalTable& tissues);

  /// Equation 3 of the thesis: returns the pressure that shortens the column by `shortening_mm`.
  ColumnLoad loadAtShortening(double shortening_mm, const LengthByLabel& length_mm) const;

  /// Returns the maximum by which the column can be shortened.
  double limit_mm(const LengthByLabel& length_mm) const;

  /// Equation 4 of the thesis: returns the relative shortening of a spring.
  double strain(std::uint8_t label, double pressure_kPa) const;

 private:
  std::array<double, kLabelCount> compliance_perkPa{};
  std::array<int, kLabelCount> softestFirst{};
};

}  // namespace insonate::column
