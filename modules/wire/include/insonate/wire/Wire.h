#pragma once

#include <insonate/core/Result.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

enum class WireKind { Guidewire, Dilator, Catheter };

/// Part of a guidewire or catheter with uniform properties.
struct WireSection {
  double length_mm = 0;              ///< 0.1 to 2000
  double bendingStiffness_Nmm2 = 0;  ///< E I; 0.05 to 20000
  /// Radius of the curve of the free section, 1 to 1000; 0: straight. All curved sections bend in the same plane.
  double restRadius_mm = 0;
  double kinkRadius_mm = 0;  ///< radius of curvature below which the section kinks, 0.5 to 200
};

/// A guidewire, dilator or catheter, described by its cross-section and by its sections, beginning at the tip.
struct Wire {
  std::string name;
  WireKind kind = WireKind::Guidewire;
  double diameter_mm = 0;       ///< outer diameter, 0.2 to 6
  double innerDiameter_mm = 0;  ///< diameter of the lumen, 0 to 95 % of `diameter_mm`; 0: none
  double friction = 0;          ///< coefficient of Coulomb friction on the vessel wall, 0 to 1
  std::vector<WireSection> sections;
};

double lengthOf_mm(const Wire& wire);
std::string_view nameOf(WireKind kind);

/// Refuses numbers out of range, and a wire without sections, with a sentence.
Result<void> validate(const Wire& wire);

/// Returns the names of the built-in wires (resources/wires).
std::vector<std::string> wirePresetNames();
/// Loads a built-in wire by name, or a wire file by path.
Result<Wire> loadWire(std::string_view nameOrPath);
/// Reads a wire from the text of a wire file. Each number in the file is an object with "value" and "source".
Result<Wire> parseWire(std::string_view text);

}  // namespace insonate
