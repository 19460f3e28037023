#pragma once

#include <insonate/core/Hash.h>
#include <insonate/image/Volume.h>

#include <cmath>
#include <cstring>

namespace insonate::test {

/// A neck of simple solids, defined in patient space (mm, LPS, z head-foot), so that any grid can sample it:
/// a cylinder of 60 mm radius with 8 mm of fat and skin over it, a bone ring with marrow and, beside it, a canal, an
/// airway that leaves through a nostril, an arm 14 mm away from the neck but joined at the shoulder, a couch, and
/// noise.
struct SimpleNeck {
  bool contrast = false;  ///< a vessel of 12 mm as bright as bone
  double noise_HU = 15;
  double skin_mm = 2;

  static constexpr double kRadius_mm = 60;
  static constexpr Vec3 kAirway{0, -25, 0}, kVertebra{0, 25, 0}, kVessel{-28, -10, 0}, kArm{105, 0, 0};
  static constexpr Vec3 kNostril{0, -45, 30};

  int hounsfield(Vec3 p) const {
    const auto fromAxis = [&](Vec3 axis) { return std::hypot(p.x - axis.x, p.y - axis.y); };
    if (fromAxis(kAirway) < 9) return -1000;
    if (std::hypot(p.x - kNostril.x, p.z - kNostril.z) < 4 && p.y < kAirway.y) return -1000;
    const double neck = fromAxis({}), arm = fromAxis(kArm), vertebra = fromAxis(kVertebra);
    const bool shoulder = p.z < -45 && std::abs(p.y) < 30 && p.x > 0 && p.x < kArm.x;
    if (neck < kRadius_mm) {
      if (vertebra < 6) return 30;  // canal
      if (vertebra < 15) return vertebra < 9 || vertebra > 12 ? 900 : 250;
      if (contrast && fromAxis(kVessel) < 6) return 480;
      return neck < kRadius_mm - 10 ? 55 : neck < kRadius_mm - skin_mm ? -100 : 35;
    }
    if (arm < 31 || shoulder) return arm < 20 ? 55 : arm < 29 || shoulder ? -100 : 35;
    if (p.y > 75 && p.y < 78) return 100;  // couch
    return -1000;
  }

  CtVolume sampledOn(const VolumeGeometry& g) const {
    CtVolume ct(g);
    const Transform patientFromIndex = g.patientFromIndex();
    for (int k = 0; k < g.size[2]; ++k)
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i) {
          const double u = unitInterval(hashNode(i, j, k, 1)) + unitInterval(hashNode(i, j, k, 2)) - 1;
          const int hu = hounsfield(patientFromIndex * Vec3{double(i), double(j), double(k)});
          // The sum of two uniform numbers on [0, 1) has a standard deviation of sqrt(1/6).
          ct.at(i, j, k) = static_cast<std::int16_t>(std::lround(hu + noise_HU * u * std::sqrt(6.0)));
        }
    return ct;
  }
};

/// A grid that covers the neck, the arm and the couch, centred; the columns of `direction` say where i, j, k run.
inline VolumeGeometry gridOver(const Mat3& direction, Vec3 spacing_mm) {
  const Vec3 half{160, 100, 70};
  const Vec3 center{30, 0, 0};
  VolumeGeometry g;
  g.direction = direction;
  g.spacing_mm = spacing_mm;
  for (int a = 0; a < 3; ++a) {
    const Vec3& d = direction.column[a];
    const double extent = std::abs(d.x) * half.x + std::abs(d.y) * half.y + std::abs(d.z) * half.z;
    g.size[a] = static_cast<int>(2 * extent / spacing_mm[a]) + 1;
  }
  g.origin_mm = center - (g.center_mm() - g.origin_mm);
  return g;
}

}  // namespace insonate::test
