#include <insonate/tissue/Labels.h>
#include <insonate/views/LabelColors.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::views {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

// Machado, Oliveira, Fernandes: A physiologically-based model for simulation of color vision deficiency, IEEE TVCG 15
// (2009), severity 1, for linear sRGB.
constexpr Matrix kNormal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Matrix kDeuteranopia{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kProtanopia{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kXyzFromRgb{
    {{0.4124564, 0.3575761, 0.1804375}, {0.2126729, 0.7151522, 0.0721750}, {0.0193339, 0.1191920, 0.9503041}}};

Triple times(const Matrix& m, const Triple& v) {
  Triple result{};
  for (int row = 0; row < 3; ++row)
    for (int k = 0; k < 3; ++k) result[row] += m[row][k] * v[k];
  return result;
}

double linear(std::uint8_t value) {
  const double v = value / 255.0;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// CIE L*a*b* (D65) of a color as such an eye sees it.
Triple seen(Color color, const Matrix& eye) {
  Triple rgb = times(eye, {linear(color.red), linear(color.green), linear(color.blue)});
  for (double& v : rgb) v = std::clamp(v, 0.0, 1.0);
  Triple f = times(kXyzFromRgb, rgb);
  constexpr Triple kWhite{0.95047, 1, 1.08883};
  for (int k = 0; k < 3; ++k) {
    const double share = f[k] / kWhite[k];
    f[k] = share > 216.0 / 24389 ? std::cbrt(share) : (24389.0 / 27 * share + 16) / 116;
  }
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

/// CIEDE2000; Sharma, Wu, Dalal, Color Research and Application 30 (2005).
double difference(const Triple& one, const Triple& two) {
  constexpr double kRadians = 3.14159265358979 / 180;
  const auto seventh = [](double c) { return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + 6103515625.0)); };
  const double mean = (std::hypot(one[1], one[2]) + std::hypot(two[1], two[2])) / 2;
  const double stretch = 1 + 0.5 * (1 - seventh(mean));
  const double c1 = std::hypot(stretch * one[1], one[2]), c2 = std::hypot(stretch * two[1], two[2]);
  const auto hue = [&](const Triple& lab) {
    const double h = std::atan2(lab[2], stretch * lab[1]) / kRadians;
    return h < 0 ? h + 360 : h;
  };
  const double h1 = hue(one), h2 = hue(two);
  double dh = h2 - h1, h = (h1 + h2) / 2;
  if (c1 * c2 == 0) {
    dh = 0, h = h1 + h2;
  } else if (std::abs(dh) > 180) {
    dh += dh > 0 ? -360 : 360;
    h += h < 180 ? 180 : -180;
  }
  const double dL = two[0] - one[0], dC = c2 - c1, dH = 2 * std::sqrt(c1 * c2) * std::sin(dh / 2 * kRadians);
  const double L = (one[0] + two[0]) / 2 - 50, C = (c1 + c2) / 2;
  const double t = 1 - 0.17 * std::cos((h - 30) * kRadians) + 0.24 * std::cos(2 * h * kRadians) +
                   0.32 * std::cos((3 * h + 6) * kRadians) - 0.2 * std::cos((4 * h - 63) * kRadians);
  const double sL = 1 + 0.015 * L * L / std::sqrt(20 + L * L), sC = 1 + 0.045 * C, sH = 1 + 0.015 * C * t;
  const double turn = -2 * seventh(C) * std::sin(60 * std::exp(-std::pow((h - 275) / 25, 2)) * kRadians);
  return std::sqrt(std::pow(dL / sL, 2) + std::pow(dC / sC, 2) + std::pow(dH / sH, 2) + turn * dC / sC * dH / sH);
}

double between(Label a, Label b, ColorScheme scheme, const Matrix& eye) {
  return difference(seen(labelColor(a, scheme), eye), seen(labelColor(b, scheme), eye));
}

TEST(LabelColors, TheMeasureIsThePublishedOne) {
  // Pairs 1, 7 and 25 of Sharma's test data.
  EXPECT_NEAR(difference({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
  EXPECT_NEAR(difference({50, 0, 0}, {50, -1, 2}), 2.3669, 1e-4);
  EXPECT_NEAR(difference({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}), 1.2644, 1e-4);
}

TEST(LabelColors, VeinAndArteryAreFarApartForEveryEye) {
  for (const ColorScheme scheme : {ColorScheme::Default, ColorScheme::ColorBlindSafe})
    for (const Matrix& eye : {kNormal, kDeuteranopia, kProtanopia}) EXPECT_GT(between(kVein, kArtery, scheme, eye), 35);
  EXPECT_NEAR(between(kVein, kArtery, ColorScheme::ColorBlindSafe, kDeuteranopia), 56.6, 0.5);
}

TEST(LabelColors, SafeOnesAreAllApart) {
  double usualLeast = 100;
  for (const Matrix& eye : {kNormal, kDeuteranopia, kProtanopia})
    for (int a = 1; a < kLabelCount; ++a)
      for (int b = a + 1; b < kLabelCount; ++b) {
        EXPECT_GT(between(Label(a), Label(b), ColorScheme::ColorBlindSafe, eye), 7.5)
            << labelTable()[a].name << " and " << labelTable()[b].name;
        usualLeast = std::min(usualLeast, between(Label(a), Label(b), ColorScheme::Default, eye));
      }
  EXPECT_LT(usualLeast, 3) << "otherwise there would be no need for them";
  EXPECT_GT(between(kArtery, kSternocleidomastoid, ColorScheme::ColorBlindSafe, kDeuteranopia), 20);
}

/// An author looks at artery and vein in muscle, and at the nerve beside the vein.
TEST(LabelColors, UsualOnesOfVesselsAreFarFromWhatSurroundsThem) {
  for (const Matrix& eye : {kNormal, kDeuteranopia, kProtanopia}) {
    EXPECT_GT(between(kArtery, kMuscle, ColorScheme::Default, eye), 15);
    EXPECT_GT(between(kArtery, kSternocleidomastoid, ColorScheme::Default, eye), 15);
    EXPECT_GT(between(kVein, kMuscle, ColorScheme::Default, eye), 30);
    EXPECT_GT(between(kVein, kNerve, ColorScheme::Default, eye), 30);
    EXPECT_GT(between(kArtery, kSkin, ColorScheme::Default, eye), 10);
    EXPECT_GT(between(kMuscle, kSkin, ColorScheme::Default, eye), 10);
  }
}

TEST(LabelColors, UsualOnesAreTheTables) {
  for (const LabelInfo& info : labelTable())
    EXPECT_EQ(labelColor(info.label, ColorScheme::Default), (Color{info.color[0], info.color[1], info.color[2]}));
  EXPECT_EQ(labelColor(200, ColorScheme::Default), labelColor(kSoftTissue, ColorScheme::Default));
}

}  // namespace
}  // namespace insonate::views
