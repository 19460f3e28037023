#include "pointspread/Cysts.h"

#include <gtest/gtest.h>

#include <cmath>

namespace insonate::bench {
namespace {

/// A Gaussian echo with a plateau around it, which leaks into cysts; widths in mm, the plateau relative to the peak.
Spread gaussianSpread(double lateral_mm, double axial_mm, double plateau) {
  Spread spread;
  spread.across = 161, spread.along = 301;
  spread.echo.resize(std::size_t(spread.across) * spread.along);
  for (int x = 0; x < spread.across; ++x)
    for (int z = 0; z < spread.along; ++z) {
      const double off = std::hypot((x - 80) * spread.x_mm / lateral_mm, (z - 150) * spread.z_mm / axial_mm);
      spread.echo[std::size_t(x) * spread.along + z] = std::exp2(-4 * off * off) + plateau;
    }
  spread.slice.assign(3, 1), spread.endAcross.assign(3, 1);
  return spread;
}

TEST(Cysts, SpeckleIsFullyDevelopedAndAnEmptyCystHasFullContrast) {
  const Spread spread = gaussianSpread(0.5, 0.2, 0);
  PointSpreadFigures figures;
  addCystFigures(cystOf(spread, 4), cystOf(spread, 8), figures);
  EXPECT_NEAR(figures.speckleSnr, std::sqrt(M_PI / (4 - M_PI)), 0.08) << "1.91 for Rayleigh's distribution";
  EXPECT_NEAR(figures.cnr8, figures.speckleSnr, 0.1);
  EXPECT_GT(figures.gcnr8, 0.97);
  EXPECT_LE(figures.gcnr8, 1);
}

TEST(Cysts, LeakageLowersContrastMostInSmallCysts) {
  const Spread clean = gaussianSpread(0.5, 0.2, 0), leaky = gaussianSpread(0.5, 0.2, 0.02);
  PointSpreadFigures without, with;
  addCystFigures(cystOf(clean, 4), cystOf(clean, 8), without);
  addCystFigures(cystOf(leaky, 4), cystOf(leaky, 8), with);
  EXPECT_LT(with.gcnr4, without.gcnr4 - 0.05);
  EXPECT_LT(with.cnr4, without.cnr4 - 0.1);
  EXPECT_LT(with.gcnr4, with.gcnr8 + 0.02);
}

TEST(Cysts, EqualEchoesHaveNoContrast) {
  CystEchoes echoes;
  for (int n = 0; n < 1000; ++n) {
    echoes.inside.push_back(n % 37);
    echoes.beside.push_back((n * 7) % 37);
  }
  EXPECT_NEAR(contrastToNoise(echoes), 0, 0.02);
  EXPECT_NEAR(generalizedContrastToNoise(echoes), 0, 0.05);
}

/// Two equal side lobes of 0.1 beside a main lobe.
TEST(Cysts, SideLobesStandBeyondTheFirstMinimum) {
  Spread spread = gaussianSpread(0.5, 0.2, 0);
  EXPECT_DOUBLE_EQ(figuresOf(spread).sideLobe_dB, -120);
  for (const int x : {50, 110})
    for (int step = -3; step <= 3; ++step)
      spread.echo[std::size_t(x + step) * spread.along + 150] = 0.1 * (1 - std::abs(step) / 4.0);
  EXPECT_NEAR(figuresOf(spread).sideLobe_dB, -20, 1e-6);
}

}  // namespace
}  // namespace insonate::bench
