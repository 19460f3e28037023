#include "HardScene.h"

#include <random>

namespace insonate::test {
namespace {

using ManyMoves = HardScene;

/// As a live image asks: few iterations, and the next question goes on from there. Mostly small moves, some anywhere.
TEST_F(ManyMoves, TenThousand) {
  make(8, 2);
  std::mt19937 random(17);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  double press_mm = 0;
  for (int k = 0; k < 10000; ++k) {
    if (k % 50 == 0) {
      press_mm = uniform(-3, 12);
      plane.tissue.slide_mm = uniform(-20, 20);
      plane.turn_deg = uniform(-30, 30);
    } else {
      press_mm = std::clamp(press_mm + uniform(-0.7, 0.7), -3.0, 10.0);
      plane.tissue.slide_mm = std::clamp(plane.tissue.slide_mm + uniform(-0.5, 0.5), -20.0, 20.0);
      plane.turn_deg = std::clamp(plane.turn_deg + uniform(-0.5, 0.5), -15.0, 15.0);
    }
    input.force_N = k % 500 < 100 ? uniform(0, 3) : 0;
    input.pressure.vein_kPa = 0.5 + 0.3 * std::sin(k * 0.05);
    ask(input.force_N > 0 ? 0 : press_mm);
  }
}

}  // namespace
}  // namespace insonate::test
