#include "Anatomy.h"

#include <algorithm>
#include <cmath>

namespace insonate::phantom {
namespace {

/// Radius of the investing fascia (mm) every 22.5 degrees from front to back, by level. The front at +48 mm is under
/// the chin; the sides below -20 mm continue into the shoulders.
const Curve<9>& fascia() {
  static const Curve<9> kFascia{
      {-64, {{56, 60, 74, 104, 140, 138, 112, 90, 80}}},      {-50, {{52, 57, 66, 92, 124, 126, 106, 86, 76}}},
      {-40, {{49, 53, 59, 75, 100, 108, 96, 80, 72}}},        {-30, {{48, 51, 54.5, 62, 80, 91, 85, 74, 67}}},
      {-20, {{47.5, 50.5, 51.5, 56, 66, 76, 75, 68, 63}}},    {-8, {{48, 51.2, 51.3, 54.6, 58.5, 65, 67, 63, 60}}},
      {5, {{49, 51.6, 51.5, 54, 56.5, 60, 62.5, 60, 57.5}}},  {20, {{51, 51, 51.5, 52.5, 54.5, 58, 60, 58, 56}}},
      {32, {{55, 54, 53.5, 53, 54.5, 58, 59.5, 57.5, 55.5}}}, {50, {{76, 70, 60, 55.5, 55.5, 58.5, 60, 58, 56}}}};
  return kFascia;
}

double neckFat(double angle, double z_mm) {
  const double back = 0.5 * (1 - std::cos(angle));                            // thicker over the nape
  const double chin = std::max(0.0, (z_mm - 15) / 35) * std::cos(angle / 2);  // and under the chin
  return 1 + 0.25 * back + 0.5 * chin;
}

}  // namespace

const Outline& neckOutline() {
  static const Outline kNeck{fascia(), neckFat};
  return kNeck;
}

}  // namespace insonate::phantom
