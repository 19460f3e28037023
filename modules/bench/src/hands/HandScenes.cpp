#include "hands/HandScenes.h"

#include <cmath>
#include <numbers>
#include <random>

namespace insonate::bench {
namespace {

/// Rotation about the camera's x axis, then about its y axis, degrees.
Mat3 tilted(double x_deg, double y_deg) {
  const double x = x_deg * std::numbers::pi / 180, y = y_deg * std::numbers::pi / 180;
  const Mat3 aboutX{{Vec3{1, 0, 0}, Vec3{0, std::cos(x), std::sin(x)}, Vec3{0, -std::sin(x), std::cos(x)}}};
  const Mat3 aboutY{{Vec3{std::cos(y), 0, -std::sin(y)}, Vec3{0, 1, 0}, Vec3{std::sin(y), 0, std::cos(y)}}};
  return aboutY * aboutX;
}

/// Lens of a usual laptop camera.
LensModel laptopLens(int width, int height) {
  LensModel lens = lensWithoutDistortion(1280, 720, 68);
  lens.cx_px += 9, lens.cy_px -= 6;
  lens.k1 = 0.07, lens.k2 = -0.16, lens.p1 = 0.0008, lens.p2 = -0.0005;
  if (width * 9 == height * 16) return scaledLens(lens, width, height);
  // A sensor with another aspect ratio shows the same height.
  const double scale = double(height) / 720;
  lens.cx_px = 0.5 * width + (lens.cx_px - 640) * scale, lens.cy_px *= scale;
  lens.fx_px *= scale, lens.fy_px *= scale;
  lens.width = width, lens.height = height;
  return lens;
}

struct Motion {
  double position_mm = 18, rotation_deg = 10, frequency_Hz = 0.6;
};

HandScene sceneOf(std::string name, const TagBody& needle, const TagBody& probe, const Motion& motion, unsigned seed,
                  double distance_mm = 500) {
  HandScene scene{std::move(name), {}, needle, probe, {}};
  scene.sensor.lens = laptopLens(1280, 720);
  const SimulatedMotion ofNeedle({tilted(-70, 25), {0.11 * distance_mm, -20, distance_mm}}, motion.position_mm,
                                 motion.rotation_deg, motion.frequency_Hz, seed);
  const SimulatedMotion ofProbe({tilted(-95, -20), {-0.14 * distance_mm, 0, distance_mm + 20}}, motion.position_mm,
                                motion.rotation_deg, motion.frequency_Hz, seed + 1);
  scene.objects = {{needle, [ofNeedle](double t) { return ofNeedle.at(t); }, {}},
                   {probe, [ofProbe](double t) { return ofProbe.at(t); }, {}}};
  return scene;
}

/// Fingers on three faces around the body, in its lower half.
void addFingers(SimulatedObject& object) {
  for (const std::size_t face : {std::size_t(2), std::size_t(7), std::size_t(9)}) {
    Vec3 middle;
    for (const Vec3& corner : cornersOf(object.body, int(face))) middle = middle + corner;
    object.fingers.push_back({normalized(middle) * (norm(middle) / 5 + 4), 9});
  }
}

/// A body as a person folds it from paper: tags are off, and the printer's scale is not exact.
TagBody foldedFromPaper(TagBody body, unsigned seed) {
  constexpr double kScale = 1.003, kShift_mm = 0.3, kTurn_deg = 0.5;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (Vec3& vertex : body.vertices_mm) vertex = vertex * kScale;
  for (BodyTag& tag : body.tags) {
    const double turn = kTurn_deg * normal(random) * std::numbers::pi / 180;
    const auto [x, y, z] = tag.bodyFromTag.linear.column;
    tag.bodyFromTag.linear.column = {x * std::cos(turn) + y * std::sin(turn), y * std::cos(turn) - x * std::sin(turn),
                                     z};
    tag.bodyFromTag.offset = tag.bodyFromTag.offset * kScale + (x * normal(random) + y * normal(random)) * kShift_mm;
    tag.size_mm *= kScale;
  }
  return body;
}

}  // namespace

Result<std::vector<HandScene>> handScenes() {
  const auto needle = loadTagBody("needle"), probe = loadTagBody("probe");
  if (!needle) return tl::unexpected(needle.error());
  if (!probe) return tl::unexpected(probe.error());
  std::vector<HandScene> scenes;
  unsigned seed = 90500;
  const auto add = [&](const char* name, const Motion& motion, double distance_mm) -> HandScene& {
    seed += 10;
    scenes.push_back(sceneOf(name, *needle, *probe, motion, seed, distance_mm));
    return scenes.back();
  };
  const Motion usual;
  add("at rest", {0, 0, 0}, 500);
  add("usual motion", usual, 500);
  add("fast motion", {22, 12, 1.6}, 500).sensor.exposure_ms = 12;
  HandScene& dark = add("low light", usual, 500);
  dark.sensor.white = 60, dark.sensor.noise = 3, dark.sensor.exposure_ms = 20;
  add("noise", usual, 500).sensor.noise = 8;
  for (SimulatedObject& object : add("fingers on three faces", usual, 500).objects) addFingers(object);
  add("out of focus", usual, 500).sensor.blur_px = 1.8;
  LensModel& lens = add("strong distortion", usual, 500).sensor.lens;
  lens.k1 = -0.3, lens.k2 = 0.09;
  add("640 x 480", usual, 500).sensor.lens = laptopLens(640, 480);
  add("1920 x 1080", usual, 500).sensor.lens = laptopLens(1920, 1080);
  add("distance 35 cm", usual, 350);
  add("distance 80 cm", usual, 800);
  HandScene& paper = add("paper body", usual, 500);
  for (SimulatedObject& object : paper.objects) object.body = foldedFromPaper(object.body, ++seed);
  return scenes;
}

}  // namespace insonate::bench
