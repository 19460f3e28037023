#include "CieLab.h"

#include <insonate/core/Transform.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

// Linear sRGB (IEC 61966-2-1, white D65) to XYZ under D50 by the Bradford adaptation, as in ICC profiles of sRGB.
const Mat3 kXyzFromLinear{{Vec3{0.4360747, 0.2225045, 0.0139322}, Vec3{0.3850649, 0.7168786, 0.0971045},
                           Vec3{0.1430804, 0.0606169, 0.7141733}}};
constexpr double kBend = 6.0 / 29;  // CIE 15: below, a line replaces the cube root

double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}
double gamma(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}
double toLab(double share) {
  return share > kBend * kBend * kBend ? std::cbrt(share) : share / (3 * kBend * kBend) + 4.0 / 29;
}
double fromLab(double f) {
  return f > kBend ? f * f * f : 3 * kBend * kBend * (f - 4.0 / 29);
}

std::uint16_t stored(double share) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * 65535));
}

Vec3 white() {
  return kXyzFromLinear * Vec3{1, 1, 1};
}

}  // namespace

DicomLab dicomLabOf(const LabelColor& color) {
  const Vec3 xyz = kXyzFromLinear * Vec3{linear(color[0] / 255.0), linear(color[1] / 255.0), linear(color[2] / 255.0)};
  const Vec3 w = white();
  const double x = toLab(xyz.x / w.x), y = toLab(xyz.y / w.y), z = toLab(xyz.z / w.z);
  return {stored((116 * y - 16) / 100), stored((500 * (x - y) + 128) / 255), stored((200 * (y - z) + 128) / 255)};
}

LabelColor colorOfDicomLab(const DicomLab& lab) {
  const double y = (lab[0] / 65535.0 * 100 + 16) / 116;
  const double x = y + (lab[1] / 65535.0 * 255 - 128) / 500, z = y - (lab[2] / 65535.0 * 255 - 128) / 200;
  const Vec3 w = white();
  const Vec3 rgb = inverted(kXyzFromLinear) * Vec3{fromLab(x) * w.x, fromLab(y) * w.y, fromLab(z) * w.z};
  LabelColor color{};
  for (int c = 0; c < 3; ++c)
    color[c] = static_cast<std::uint8_t>(std::lround(std::clamp(gamma(rgb[c]), 0.0, 1.0) * 255));
  return color;
}

}  // namespace insonate
