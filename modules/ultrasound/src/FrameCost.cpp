#include "model/FramePlan.h"
#include "scene/SceneData.h"

#include <insonate/ultrasound/Display.h>
#include <insonate/ultrasound/FrameCost.h>
#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <numeric>

namespace insonate {
namespace {

constexpr double kFloat = 4, kDistance = 2;  // bytes

/// Trilinear look-up of every structure's distance at each node, and the two nearest structures of each cell.
StageCost structures(const FramePlan& plan, const TissueField& field) {
  const double nodes = double(plan.nodeRows) * plan.nodeColumns * plan.settings.elevationPlanes;
  constexpr double kPosition = 30, kCorners = 30;              // patient to lattice; eight weights
  constexpr double kPair = 5, kBoundary = 4 * 8, kAngle = 40;  // a channel; distances of the pair; cosine, averages
  const double perNode = kPosition + kCorners + 8 * 2 * field.channels;
  const double perCell = kPair * field.channels + kBoundary + kAngle;
  const double read = 8 * TissueField::kStride * kDistance, written = (field.channels + 16) * kFloat;
  return {"structures", nodes * (perNode + perCell), nodes * (read + written)};
}

/// One scatterer cell of four corners, hashed, for each gate of each plane.
StageCost echoes(const FramePlan& plan) {
  const double looks = plan.settings.looks;
  const double points = double(plan.gates) * plan.lines * plan.settings.elevationPlanes;
  constexpr double kPlace = 20, kLevels = 20, kPower = 15;      // position; pair, loss, layers; 10^(dB/20)
  constexpr double kTexture = 25, kLattice = 40, kHashes = 60;  // one tile; weights and order of four corners; hashes
  const double perLook = 2 * 4 * 5;                             // complex; corners; unpack, convert, multiply-add
  const double perPoint = kPlace + kLevels + kPower + kTexture + kLattice + kHashes + perLook * looks;
  return {"echoes", points * perPoint, double(plan.gates) * plan.lines * 2 * looks * kFloat};
}

/// A symmetric kernel takes one multiply, then an addition and a multiply-add for each pair of taps.
double kernelOperations(double radius) {
  return 1 + 3 * radius;
}

StageCost axialBeam(const FramePlan& plan) {
  const double rows = 2.0 * plan.settings.looks * plan.lines;
  double perRow = 0;
  for (const int radius : plan.axialRadius) perRow += kernelOperations(radius);
  return {"axial beam", rows * perRow, rows * plan.gates * 2 * kFloat};
}

StageCost lateralBeam(const FramePlan& plan) {
  const double looks = plan.settings.looks, samples = double(plan.grid.samples()) * plan.lines;
  double perLine = 0;
  for (const int radius : plan.lateralRadius) perLine += kernelOperations(radius);
  constexpr double kMagnitude = 2 * 4 * 2 + 4;  // cubic interpolation of a complex value, and its root
  return {"lateral beam", 2 * looks * perLine * plan.lines + looks * samples * kMagnitude,
          (2 * looks * plan.gates * plan.lines + looks * samples) * kFloat};
}

}  // namespace

double sceneDetail_mm(const Probe& probe, const ImagingSettings& settings) {
  constexpr double kCoarse_mm = 1.2;
  const bool fineBeam = lateralFwhm_mm(probe, settings, settings.focus_mm) < kCoarse_mm;
  return fineBeam ? AcousticScene::kFinestDetail_mm : kCoarse_mm;
}

double gateDistance_mm(const Probe& probe, const ImagingSettings& settings) {
  return FramePlan(probe, settings).gate_mm;
}

std::vector<StageCost> frameCost(const Probe& probe, const ImagingSettings& settings, const AcousticScene& scene) {
  const FramePlan plan(probe, settings);
  const double samples = double(settings.samples) * settings.scanlines, looks = settings.looks;
  const std::vector<std::uint8_t> mask = fieldOfViewMask(probe, settings);
  const double pixels = std::accumulate(mask.begin(), mask.end(), 0.0);
  constexpr double kLogarithm = 25, kSmoothing = 110, kGrey = 8;  // an operation count each, a sample
  constexpr double kBilinear = 12;                                // a pixel
  std::vector<StageCost> work{structures(plan, scene.impl().field), echoes(plan), axialBeam(plan), lateralBeam(plan)};
  work.push_back({"compound", samples * (2 * looks + 6), samples * (looks + 1) * kFloat});
  work.push_back({"compress", samples * kLogarithm, samples * 2 * kFloat});
  work.push_back(
      {"smooth", samples * ((settings.speckleReduction > 0 ? kSmoothing : 0) + kGrey), samples * (kFloat + 1)});
  work.push_back({"scan_convert", pixels * kBilinear, samples * (1 + 4) + pixels * (4 + 4 + 2 + 1)});
  return work;
}

}  // namespace insonate
