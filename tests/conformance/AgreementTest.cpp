#include "conformance/Measure.h"
#include "conformance/Rig.h"
#include "support/Ssim.h"

#include <insonate/ultrasound/Display.h>

#include <algorithm>
#include <cmath>

namespace insonate::test {
namespace {

std::vector<std::string> otherEngines() {
  std::vector<std::string> names = engineNames();
  std::erase(names, "reference");
  return names;
}

/// Every engine against the reference, in everything that an image can hold.
class Agreement : public EngineTest {
 protected:
  void expectAgreement(const Probe& probe, const ImagingSettings& settings, const AcousticScene& scene,
                       const Transform& pose, const std::string& what, const PlaneDisplacement& displacement = {},
                       const std::optional<Needle>& needle = {}) {
    const EnvelopeFrame truth = renderWith("reference", probe, settings, scene, pose, displacement, needle);
    const EnvelopeFrame frame = renderWith(GetParam(), probe, settings, scene, pose, displacement, needle);
    ASSERT_EQ(frame.amplitude.size(), truth.amplitude.size()) << what;
    const double error = relativeError(frame, truth);
    EXPECT_LT(error, 0.005) << what;
    BModeImage seen, meant;
    Display(probe, settings).process(frame, seen);
    Display(probe, settings).process(truth, meant);
    const double similarity = ssim(seen.gray, meant.gray, meant.width, meant.height);
    EXPECT_GT(similarity, 0.99) << what;
    worstError_ = std::max(worstError_, error);
    worstSsim_ = std::min(worstSsim_, similarity);
  }
  void TearDown() override {
    record("worst_relative_error", worstError_);
    record("worst_ssim", worstSsim_);
  }

 private:
  double worstError_ = 0, worstSsim_ = 1;
};
INSTANTIATE_TEST_SUITE_P(Engines, Agreement, testing::ValuesIn(otherEngines()), engineTestName);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Agreement);

/// A round limb: skin, fat, muscle, vessels, airway and bone, 100 mm across, its axis along patient z, on a grid with
/// HU that vary within structures.
LabelPhantom limb() {
  return paint(
      gridOver({-56, -63, -14}, {56, 14, 14}, {0.7, 0.7, 1.4}),
      [](Vec3 p) {
        const double r = std::hypot(p.x, p.y);
        if (r > 50) return kBackground;
        if (r > 48) return kSkin;
        if (r > 43) return kFat;
        if (std::hypot(p.x - 6, p.y + 32 + 0.2 * p.z) < 5.5) return kVein;
        if (std::hypot(p.x + 8, p.y + 28) < 3.4) return kArtery;
        if (std::hypot(p.x, p.y + 5) < 9) return kAirway;
        if (std::hypot(p.x - 20, p.y + 15) < 8) return kBone;
        if (std::hypot(p.x + 18, p.y + 18) < 6) return kThyroid;
        return r > 36 ? kSternocleidomastoid : kMuscle;
      },
      [](Vec3 p) { return std::lround(40 + 30 * std::sin(p.x) * std::cos(0.7 * p.y) + 15 * std::sin(0.5 * p.z)); });
}

const Region kWhole{{-60, -70, -14}, {60, 20, 14}}, kNearby{{-22, -60, -6}, {22, 0, 6}};

/// Face on the front of the limb, beam toward its axis, scanlines across it.
Transform onSkin(double pressed_mm = 0) {
  Transform pose;
  pose.linear = {{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}};
  pose.offset = {0, -50 + pressed_mm, 0};
  return pose;
}

TEST_P(Agreement, ForEveryProbeAndPose) {
  const LabelPhantom phantom = limb();
  const AcousticTable table = *loadAcousticTable("neck");
  const std::vector<std::pair<const char*, Transform>> poses{
      {"across", onSkin()},
      {"along", onSkin(1) * turned({0, 0, 1}, 90)},
      {"oblique", onSkin(2) * turned({1, 2, 3}, 25)},
  };
  const ScenePtr scene = sceneOf(phantom, table, kWhole);
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    const Probe probe = probeNamed(name);
    ImagingSettings settings = settingsFor(probe);
    settings.scanlines = 128, settings.samples = 400;
    settings.depth_mm = 50;
    for (const auto& [pose, patientFromProbe] : poses)
      expectAgreement(probe, settings, *scene, patientFromProbe, std::string(name) + " " + pose);
  }
}

TEST_P(Agreement, ForEverySetting) {
  const LabelPhantom phantom = limb();
  const AcousticTable table = *loadAcousticTable("neck");
  const Probe probe = probeNamed("linear");
  ImagingSettings base = settingsFor(probe);
  base.scanlines = 128, base.samples = 500;
  const ScenePtr scene = sceneOf(phantom, table, kNearby);
  const auto check = [&](const char* what, auto change) {
    ImagingSettings settings = base;
    change(settings);
    expectAgreement(probe, settings, *scene, onSkin() * turned({0, 1, 0}, 4), what);
  };
  check("1 plane", [](auto& s) { s.elevationPlanes = 1; });
  check("5 planes", [](auto& s) { s.elevationPlanes = 5, s.looks = 1; });
  check("9 planes", [](auto& s) { s.elevationPlanes = 9, s.looks = 1, s.samples = 200; });
  check("256 scanlines", [](auto& s) { s.scanlines = 256; });
  check("300 scanlines of 1037 samples", [](auto& s) { s.scanlines = 300, s.samples = 1037, s.looks = 1; });
  check("77 scanlines of 64 samples", [](auto& s) { s.scanlines = 77, s.samples = 64; });
  check("16 scanlines", [](auto& s) { s.scanlines = 16; });
  check("20 mm deep", [](auto& s) { s.depth_mm = 20; });
  check("60 mm deep", [](auto& s) { s.depth_mm = 60, s.frequency_MHz = 5; });
  check("13 MHz", [](auto& s) { s.frequency_MHz = 13, s.focus_mm = 8; });
  check("2 looks", [](auto& s) { s.looks = 2; });
  check("rigid skin", [](auto& s) { s.conformingContact = false; });
}

TEST_P(Agreement, WithoutEachEffect) {
  const LabelPhantom phantom = limb();
  const AcousticTable table = *loadAcousticTable("neck");
  const Probe probe = probeNamed("linear");
  const ScenePtr scene = sceneOf(phantom, table, kNearby);
  for (bool Effects::*effect :
       {&Effects::scattering, &Effects::reflection, &Effects::attenuation, &Effects::transmission, &Effects::speckle,
        &Effects::layers, &Effects::texture, &Effects::beam, &Effects::reverberation, &Effects::edgeShadow}) {
    ImagingSettings settings = settingsFor(probe);
    settings.scanlines = 100, settings.samples = 333;
    settings.effects.*effect = false;
    expectAgreement(probe, settings, *scene, onSkin(), "an effect left out");
  }
}

TEST_P(Agreement, InTheLookOfTheThesis) {
  const LabelPhantom phantom = limb();
  const AcousticTable table = *loadAcousticTable("thesis");
  const ScenePtr scene = sceneOf(phantom, table, kWhole);
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    const Probe probe = probeNamed(name);
    ImagingSettings settings = settingsFor(probe);
    settings.look = Look::Thesis;
    settings.scanlines = 77, settings.samples = 333, settings.depth_mm = 50;
    expectAgreement(probe, settings, *scene, onSkin() * turned({1, 2, 3}, 15), name);
  }
}

/// Pressed, pushed aside and turned, with kinks at the lattice's points.
PlaneDisplacement squeezed(const Probe& probe, const ImagingSettings& settings) {
  return displacementOver(probe, settings, 0.9, [](double x, double z) {
    const auto swirl = swirlAt(x, z, 2, 16, 25, 9);
    const double into = std::exp(-std::max(z, 0.0) / 18);
    return shiftBy(swirl.x_mm - 0.06 * x * into, swirl.z_mm - 4 * into);
  });
}

TEST_P(Agreement, OfDisplacedTissue) {
  const LabelPhantom phantom = limb();
  for (const Look look : {Look::Coherent, Look::Thesis}) {
    const AcousticTable table = *loadAcousticTable(look == Look::Thesis ? "thesis" : "neck");
    const ScenePtr scene = sceneOf(phantom, table, kWhole, {{{4, -34, 0.3}, 50}});
    for (const char* name : {"linear", "curvilinear", "phased"})
      for (const int planes : {1, 3}) {
        const Probe probe = probeNamed(name);
        ImagingSettings settings = settingsFor(probe);
        settings.look = look;
        settings.scanlines = 131, settings.samples = 400, settings.elevationPlanes = planes;
        settings.depth_mm = 50;
        for (const double pressed_mm : {4.0, 1.0})
          expectAgreement(probe, settings, *scene, onSkin(pressed_mm) * turned({1, 2, 3}, 12),
                          std::string(name) + " " + std::to_string(planes) + " planes", squeezed(probe, settings));
      }
  }
}

/// In the plane at three angles, across it, oblique, with the tip at the slice's edge, beside the face and along a
/// beam.
TEST_P(Agreement, WithANeedle) {
  const ScenePtr scene = sceneOf(limb(), *loadAcousticTable("neck"), kWhole);
  struct Case {
    const char* what;
    Vec3 tip_mm, direction;
  };
  const Case cases[]{{"30 degrees", {4, 0, 18}, {1.732, 0, 1}},  {"45 degrees", {4, 0, 18}, {1, 0, 1}},
                     {"60 degrees", {2, 0, 20}, {1, 0, 1.732}},  {"across", {3, 9, 26}, {0, 1, 0.6}},
                     {"square", {3, 20, 15}, {0, 1, 0}},         {"oblique", {4, 1, 22}, {1, 0.5, 1}},
                     {"at the edge", {-2, -0.8, 16}, {0, 1, 1}}, {"along a beam", {0, 0, 21}, {0, 0, 1}}};
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    const Probe probe = probeNamed(name);
    ImagingSettings settings = settingsFor(probe);
    settings.scanlines = 96, settings.samples = 400, settings.depth_mm = 50;
    double pressed_mm = -2;
    for (const Case& c : cases) {
      const Transform tilted = onSkin(pressed_mm) * turned({1, 2, 3}, 12);
      const Needle needle = needleAt(c.tip_mm, c.direction, tilted);
      expectAgreement(probe, settings, *scene, tilted, std::string(name) + " " + c.what, {}, needle);
      pressed_mm = -1 - pressed_mm;
    }
    const Transform pose = onSkin(4);
    expectAgreement(probe, settings, *scene, pose, std::string(name) + " displaced", squeezed(probe, settings),
                    needleAt({4, 0, 18}, {1, 0, 1}, pose));
  }
}

TEST_P(Agreement, InHardCases) {
  const LabelPhantom phantom = limb();
  const AcousticTable table = *loadAcousticTable("neck");
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = 128, settings.samples = 400;
  const ScenePtr scene = sceneOf(phantom, table, kWhole);
  const auto check = [&](const char* what, const Transform& pose) {
    expectAgreement(probe, settings, *scene, pose, what);
  };
  check("half off the skin", onSkin() * moved({38, 0, 0}));
  check("tilted 60 degrees", onSkin() * turned({1, 0, 0}, 60));
  check("rocked 60 degrees", onSkin() * turned({0, 1, 0}, 60));
  check("deep inside", onSkin(25));
  check("beyond the end of the volume", onSkin() * moved({0, 13, 0}));
}

}  // namespace
}  // namespace insonate::test
