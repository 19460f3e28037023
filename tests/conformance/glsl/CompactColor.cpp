#include "conformance/glsl/CompactColor.h"

#include <cmath>

namespace insonate::test {
namespace {

constexpr double kArteryRadius_mm = 3, kVeinRadius_mm = 4;

/// Center lines bend in the plane of the image and across it, and the vessels become narrower.
Vec3 arteryAt(double t) {
  return {-5 + 3 * std::sin(0.15 * t), 0.4 * t, 9 + 0.35 * t};
}
Vec3 veinAt(double t) {
  return {6 + 0.2 * t, -0.5 * t, 13 + 2 * std::cos(0.1 * t)};
}

template <class PointAt>
BloodTube tubeOf(std::uint8_t label, double radius_mm, double speed_mmps, const PointAt& at) {
  BloodTube tube;
  tube.label = label;
  for (double t = -20; t <= 20; t += 4) {
    const Vec3 way = at(t + 0.1) - at(t - 0.1);
    tube.course.push_back({at(t), way / norm(way), radius_mm * (1 - 0.01 * t), 1 + 0.03 * t});
  }
  for (int i = 0; i < BloodTube::kProfile; ++i) {
    const double x = double(i) / (BloodTube::kProfile - 1);
    tube.profile_mmps[i] = speed_mmps * (1 - x * x * x);
  }
  return tube;
}

template <class PointAt>
bool isIn(Vec3 p, double radius_mm, const PointAt& at) {
  for (double t = -20; t <= 20; t += 1)
    if (norm(p - at(t)) < radius_mm * (1 - 0.01 * t)) return true;
  return false;
}

/// Skin that slopes, with gel before it, vessels, bone and muscle. The probe frame of onSkin(0) is the patient frame.
LabelPhantom tissueWith(bool artery, bool vein) {
  return paint(gridOver({-26, -10, -14}, {26, 10, 34}, 0.8), [=](Vec3 p) {
    if (p.z < 0.05 * p.x) return kBackground;
    if (artery && isIn(p, kArteryRadius_mm, arteryAt)) return kArtery;
    if (vein && isIn(p, kVeinRadius_mm, veinAt)) return kVein;
    if (std::hypot(p.x - 1, p.z - 6) < 2) return kBone;
    return p.z < 3 ? kFat : kMuscle;
  });
}

class Colors {
 public:
  std::vector<CompactColor> all;

  template <class Change>
  void add(const std::string& what, const char* probeName, const ScenePtr& scene, const Change& change) {
    CompactColor c;
    c.what = what, c.probe = probeNamed(probeName), c.scene = scene;
    c.settings = silentSettings(c.probe, 64, 200, 3);
    c.settings.effects.attenuation = c.settings.effects.transmission = c.settings.conformingContact = true;
    c.color = colorSettingsFor(c.probe, c.settings);
    c.color.near_mm = 4, c.color.far_mm = 20, c.color.left = 0.1, c.color.right = 0.9;
    c.pose = moved({0, 0, -1});
    c.flow.tubes = {tubeOf(kArtery, kArteryRadius_mm, 260, arteryAt), tubeOf(kVein, kVeinRadius_mm, -150, veinAt)};
    change(c);
    all.push_back(std::move(c));
  }
};

}  // namespace

std::vector<CompactColor> compactColors() {
  const Region region{{-30, -12, -16}, {30, 12, 38}};
  const AcousticTable table = *loadAcousticTable("neck");
  const ScenePtr scene = sceneOf(tissueWith(true, true), table, region);
  Colors colors;
  colors.add("linear", "linear", scene, [](CompactColor& c) { c.color.steering_deg = 12; });
  colors.add("fan", "curvilinear", scene, [](CompactColor& c) { c.color.left = 0.3, c.color.right = 0.7; });
  colors.add("moving probe", "linear", scene, [](CompactColor& c) { c.tissue_mmps = {30, 10, -60}; });
  colors.add("probe that moves half a wavelength between pulses", "linear", scene, [](CompactColor& c) {
    c.tissue_mmps = {0, 0, -2.04 * nyquistVelocity_mmps(c.color)};
  });
  colors.add("artery along the vein", "linear", scene,
             [](CompactColor& c) { c.flow.tubes = {tubeOf(kArtery, kVeinRadius_mm, 260, veinAt)}; });
  colors.add("no wall filter", "linear", scene, [](CompactColor& c) { c.color.wallFilter_Hz = 0; });
  colors.add("a low wall filter", "linear", scene, [](CompactColor& c) {
    c.color.wallFilter_Hz = 0.01, c.tissue_mmps = {0, 0, 40};
  });
  colors.add("hardly in contact", "linear", scene, [](CompactColor& c) { c.pose = moved({0, 0, -7.3}); });
  colors.add("rigid skin", "linear", scene, [](CompactColor& c) {
    c.pose = moved({0, 0, -4}), c.settings.conformingContact = false;
  });
  colors.add("turned", "linear", scene, [](CompactColor& c) { c.pose = c.pose * turned({0.2, 1, 0.6}, 20); });
  colors.add("displaced", "linear", scene, [](CompactColor& c) {
    c.displacement =
        displacementOver(c.probe, c.settings, 1, [](double x, double z) { return swirlAt(x, z, 2, 12, 14, 8); });
  });
  colors.add("boundaries alone", "linear", scene,
             [](CompactColor& c) { c.settings.effects.attenuation = false, c.color.wallFilter_Hz = 0; });
  colors.add("without blood flow", "linear", scene, [](CompactColor& c) {
    c.flow.tubes.clear(), c.tissue_mmps = {0, 0, -60};
  });
  for (const bool artery : {true, false})
    colors.add("one kind of vessel", "linear", sceneOf(tissueWith(artery, !artery), table, region),
               [](CompactColor& c) {
                 c.tissue_mmps = {0, 0, -60};
               });
  return colors.all;
}

ColorFrame colorWith(ColorDoppler& doppler, const CompactColor& c) {
  ColorFrame frame;
  doppler.prepare(c.probe, c.settings, c.color);
  doppler.render(*c.scene, c.pose, c.displacement, c.motion(), frame);
  return frame;
}

double colorErrorOf(const ColorFrame& frame, const ColorFrame& truth) {
  if (frame.power.size() != truth.power.size()) return 1;
  double error = 0, sum = 0;
  for (std::size_t i = 0; i < truth.power.size(); ++i) {
    const double dp = frame.power[i] - truth.power[i], dr = frame.lagOneRe[i] - truth.lagOneRe[i],
                 di = frame.lagOneIm[i] - truth.lagOneIm[i];
    error += dp * dp + dr * dr + di * di;
    sum += 2 * double(truth.power[i]) * truth.power[i];
  }
  const double share = std::sqrt(error / sum);
  return std::isfinite(share) ? share : 1;
}

}  // namespace insonate::test
