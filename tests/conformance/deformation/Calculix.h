#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace insonate::test {

/// A block of tissue with a circle in it, for CalculiX (an independent finite-element program, run as `ccx`): plane
/// strain of quadratic elements (CPE8; the reduced CPE8R has single nodes that go to and fro), a millimeter wide, of
/// which those that a circle cuts are two triangles (CPE6). x to the right, z down from the top, mm; the bottom is
/// held.
struct CalculixBlock {
  double width_mm = 60, height_mm = 40;
  double sides_mm = 30;  ///< from the middle; beyond half the width elements grow
  bool sidesHeld = true;
  struct Material {
    double young_kPa = 10, poisson = 0.49;
  } tissue;
  struct Circle {
    double x_mm = 0, z_mm = 15, radius_mm = 5;
    bool hollow = false;
    double pressure_kPa = 0;  ///< in a hollow one
    Material material;        ///< of a full one
  };
  std::vector<Circle> circles;
  /// Displacement of the top at x, mm along x and z; empty where it is free.
  std::function<std::optional<std::array<double, 2>>(double x_mm)> press;
};

struct CalculixNode {
  double x_mm = 0, z_mm = 0, moveX_mm = 0, moveZ_mm = 0;
};

struct CalculixAnswer {
  bool ran = false;
  std::vector<CalculixNode> nodes;
  double force_kPa_mm = 0;                 ///< with which the top is pressed, a millimeter of thickness
  std::vector<double> area_mm2, rest_mm2;  ///< of each hollow circle
};

bool calculixIsThere();

/// Writes its files into the folder.
CalculixAnswer solveWithCalculix(const CalculixBlock& block, const std::filesystem::path& folder);

}  // namespace insonate::test
