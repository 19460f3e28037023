#pragma once

#include <insonate/cases/Phantom.h>
#include <insonate/tissue/Labels.h>
#include <insonate/wire/WireSolver.h>

#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace insonate::test {

/// A tube along a curve p(s), s from 0 to `length_mm`.
template <class Curve>
NamedVessel tube(const std::string& name, double length_mm, double radius_mm, const Curve& curve,
                 std::uint8_t label = kVein) {
  NamedVessel vessel{name, label, {}};
  for (double s = 0; s <= length_mm + 1e-9; s += 5) vessel.course.push_back({curve(s), radius_mm});
  return vessel;
}

inline NamedVessel straightVein(double length_mm, double radius_mm) {
  return tube("test vein", length_mm, radius_mm, [](double s) { return Vec3{0, 0, s}; });
}

inline VesselTree treeOf(const std::vector<NamedVessel>& vessels) {
  return VesselTree::make(vessels).value();
}

/// The manifest of a built-in neck.
inline const CaseManifest& neckNamed(const std::string& variant) {
  static std::map<std::string, CaseManifest> made;
  const auto found = made.find(variant);
  return found != made.end() ? found->second : made[variant] = makePhantom(variant, 1, {}).value().manifest;
}

/// Straight wire with the same stiffness along its length.
inline Wire plainWire(double stiffness_Nmm2, double length_mm = 300) {
  Wire wire;
  wire.name = "plain", wire.diameter_mm = 0.8;
  wire.sections = {{length_mm, stiffness_Nmm2, 0, 0.5}};
  return wire;
}

}  // namespace insonate::test
