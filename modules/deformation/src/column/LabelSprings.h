#pragma once

#include <insonate/tissue/MechanicalTable.h>

#include <array>

namespace insonate::column {

/// No spring is shortened by more than this share of its length, so that nothing folds. It matters only where the
/// linear law of the springs would press tissue to nothing.
inline constexpr double kMaxShortening = 0.9;

/// Young's modulus, kPa, with which a lumen enters a column: Table I of the thesis. A spring can be soft; it cannot be
/// emptied or filled as a vessel is.
inline constexpr double kArteryLumen_kPa = 200, kVeinLumen_kPa = 23;

/// Length of each label in a column, mm.
using LengthByLabel = std::array<double, kLabelCount>;

struct ColumnLoad {
  double pressure_kPa = 0;  ///< the same in all springs of a column
  double shortening_mm = 0;
  bool limited = false;  ///< shorter than asked for: rigid, or at kMaxShortening
};

/// Springs in series by label. A label's compliance is 1 / E in 1/kPa, so that an infinite modulus is exactly 0.
class LabelSprings {
 public:
  explicit LabelSprings(const MechanicalTable& tissues);

  /// Equation 3: the pressure that shortens the column by `shortening_mm`.
  ColumnLoad loadAtShortening(double shortening_mm, const LengthByLabel& length_mm) const;

  /// The most by which it can be shortened.
  double limit_mm(const LengthByLabel& length_mm) const;

  /// Equation 4: the share of its length that a spring loses.
  double strain(std::uint8_t label, double pressure_kPa) const;

 private:
  std::array<double, kLabelCount> compliance_perkPa{};
  std::array<int, kLabelCount> softestFirst{};
};

}  // namespace insonate::column
