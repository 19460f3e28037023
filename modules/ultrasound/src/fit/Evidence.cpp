#include "Evidence.h"

#include <algorithm>
#include <cmath>

namespace insonate::fit {
namespace {

constexpr double kStep_px = 4;
constexpr int kAreaStep_px = 4;
constexpr double kDarkInside = 0.25;  // weight of background within the model relative to image outside of it

bool within(const Plate& plate, PixelPoint p) {
  return p.x >= 0 && p.y >= 0 && p.x <= plate.smooth.cols - 1 && p.y <= plate.smooth.rows - 1;
}

float at(const Plate& plate, PixelPoint p) {
  return plate.smooth(int(std::lround(p.y)), int(std::lround(p.x)));
}

PixelPoint along(const EdgeSample& sample, double by) {
  return {sample.at.x + by * sample.outward.x, sample.at.y + by * sample.outward.y};
}

void addOutline(const FovModel& model, const Plate& plate, double tolerance, Evidence& evidence) {
  std::array<double, kEdges> all{}, visible{}, seen{}, against{};
  for (const EdgeSample& sample : edgeSamples(model, kStep_px)) {
    all[sample.edge] += 1;
    const PixelPoint out1 = along(sample, tolerance + 1), out2 = along(sample, tolerance + 3);
    const PixelPoint in1 = along(sample, -tolerance), in2 = along(sample, -tolerance - 2);
    if (!within(plate, out2) || !within(plate, in2)) continue;
    visible[sample.edge] += 1;
    const bool lightOutside = at(plate, out1) > plate.threshold || at(plate, out2) > plate.threshold;
    const bool lightInside = at(plate, in1) > plate.threshold || at(plate, in2) > plate.threshold;
    if (lightOutside)
      against[sample.edge] += 1;
    else if (lightInside)
      seen[sample.edge] += 1;
  }
  double sumVisible = 0, sumSeen = 0, sumAgainst = 0;
  for (int edge = 0; edge < kEdges; ++edge) {
    sumVisible += visible[edge], sumSeen += seen[edge], sumAgainst += against[edge];
    evidence.edges[edge] = {visible[edge] / std::max(1.0, all[edge]), seen[edge] / std::max(1.0, visible[edge]),
                            against[edge] / std::max(1.0, visible[edge])};
  }
  evidence.outline = (sumSeen - sumAgainst) / std::max(1.0, sumVisible);
  evidence.agreement = sumSeen / std::max(1.0, sumSeen + sumAgainst);
}

void addArea(const FovModel& model, const Plate& plate, Evidence& evidence) {
  const Beyond beyond(model);
  double both = 0, bodyOnly = 0, modelOnly = 0, gaps = 0;
  for (int row = kAreaStep_px / 2; row < plate.body.rows; row += kAreaStep_px)
    for (int column = kAreaStep_px / 2; column < plate.body.cols; column += kAreaStep_px) {
      const bool inside = beyond.inside({double(column), double(row)});
      const bool body = plate.body(row, column) != 0;
      gaps += inside && body && plate.gaps(row, column);
      both += inside && body, bodyOnly += !inside && body, modelOnly += inside && !body;
    }
  evidence.cover = both / std::max(1.0, both + bodyOnly + kDarkInside * modelOnly);
  evidence.gaps = gaps / std::max(1.0, both);
  evidence.filled = both / std::max(1.0, both + modelOnly);
}

}  // namespace

double outlineFor(const FovModel& model, const Plate& plate, double tolerance_px) {
  Evidence evidence;
  addOutline(model, plate, tolerance_px, evidence);
  return evidence.outline;
}

Evidence evidenceFor(const FovModel& model, const Plate& plate, double tolerance_px) {
  Evidence evidence;
  addOutline(model, plate, tolerance_px, evidence);
  addArea(model, plate, evidence);
  return evidence;
}

}  // namespace insonate::fit
