#include "unit/ultrasound/ThesisRig.h"

#include <insonate/ultrasound/Display.h>

#include <nlohmann/json.hpp>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

namespace insonate::test {
namespace {

class ThesisLook : public ThesisEngines {};
INSTANTIATE_TEST_SUITE_P(Engines, ThesisLook, testing::ValuesIn(engineNames()), thesisEngineName);

/// Skin at z = 0 under air; fat, muscle with a vein and a piece of bone; HU vary within structures.
LabelPhantom slab() {
  return paint(
      gridOver({-36, -10, -14}, {36, 10, 60}, {0.9, 0.9, 1.0}),
      [](Vec3 p) {
        const double skin = 0.002 * p.x * p.x;
        if (p.z < skin) return kBackground;
        if (p.z < skin + 2) return kSkin;
        if (p.z < skin + 6) return kFat;
        if (std::hypot(p.x + 6, p.z - 16 + 0.1 * p.y) < 5) return kVein;
        if (std::hypot(p.x - 9, p.z - 18) < 4) return kBone;
        if (std::hypot(p.x - 2, p.z - 30) < 4) return kAirway;
        return kMuscle;
      },
      [](Vec3 p) { return std::lround(30 * std::sin(0.8 * p.x) * std::cos(0.9 * p.z) + 20 * std::sin(0.7 * p.y)); });
}

ImagingSettings fullSettings(const Probe& probe, int scanlines, int samples) {
  ImagingSettings settings = settingsFor(probe);
  settings.look = Look::Thesis;
  settings.scanlines = scanlines, settings.samples = samples;
  settings.depth_mm = std::clamp(45.0, probe.minDepth_mm, probe.maxDepth_mm);
  return settings;
}

TEST_P(ThesisLook, SpeckleHasUnitPowerAndTheSamePoseTheSameImage) {
  ImagingSettings settings = thesisSettings(probe, 256, 800);
  settings.effects.scattering = settings.effects.speckle = true;
  const auto scene =
      thesisScene(paint(gridOver({-40, -12, -8}, {40, 12, 60}, 2.0), [](Vec3) { return kMuscle; }), plainTissues());
  const EnvelopeFrame frame = thesisFrame(GetParam(), probe, settings, *scene);
  ASSERT_EQ(frame.looks, 1);
  double power = 0, mean = 0;
  for (const float a : frame.amplitude) power += double(a) * a, mean += a;
  const auto n = static_cast<double>(frame.amplitude.size());
  EXPECT_NEAR(power / n, 1, 0.05);
  mean /= n;
  EXPECT_NEAR(std::sqrt(power / n - mean * mean) / mean, 0.55, 0.06);
  EXPECT_EQ(frame.amplitude, thesisFrame(GetParam(), probe, settings, *scene).amplitude);
}

TEST_P(ThesisLook, PositionOrientationAndTimeSeedTheSpeckle) {
  ImagingSettings settings = thesisSettings(probe, 128, 400);
  settings.effects.scattering = settings.effects.speckle = true;
  const auto scene =
      thesisScene(paint(gridOver({-60, -60, -60}, {60, 60, 60}, 4.0), [](Vec3) { return kMuscle; }), plainTissues());
  const auto at = [&](Transform pose, double time_s) {
    settings.time_s = time_s;
    return thesisFrame(GetParam(), probe, settings, *scene, pose);
  };
  const EnvelopeFrame first = at({}, 0);
  Transform moved, turned, hardly;
  moved.offset = {1, 0, 0};
  turned.linear = {{Vec3{std::cos(0.1), std::sin(0.1), 0}, Vec3{-std::sin(0.1), std::cos(0.1), 0}, Vec3{0, 0, 1}}};
  hardly.offset = {0.01, 0, 0};
  // Independent images differ by sqrt(2) of their SD, which is 0.48 of the RMS.
  EXPECT_NEAR(frameError(at(moved, 0), first), 0.68, 0.1);
  EXPECT_NEAR(frameError(at(turned, 0), first), 0.68, 0.1);
  EXPECT_NEAR(frameError(at({}, 0.04), first), 0.68, 0.1);
  EXPECT_LT(frameError(at(hardly, 0), first), 0.001);
}

TEST_P(ThesisLook, TimeChangesTheSpeckleOnly) {
  ImagingSettings settings = fullSettings(probe, 64, 300);
  const auto scene = thesisScene(slab(), *loadAcousticTable("thesis"));
  const auto at = [&](double time_s) {
    settings.time_s = time_s;
    return thesisFrame(GetParam(), probe, settings, *scene).amplitude;
  };
  EXPECT_NE(at(0), at(1));
  settings.effects.speckle = false;
  EXPECT_EQ(at(0), at(1));
}

TEST_P(ThesisLook, LayersAloneAreWhatTheySay) {
  const auto scene = thesisScene(slab(), *loadAcousticTable("thesis"));
  ImagingSettings settings = fullSettings(probe, 128, 500);
  const BeamGrid grid(probe, settings);
  const auto frameWith = [&](std::initializer_list<bool Effects::*> parts) {
    settings.effects = Effects::none();
    for (const auto part : parts) settings.effects.*part = true;
    return thesisFrame(GetParam(), probe, settings, *scene);
  };
  const auto at = [&](const EnvelopeFrame& frame, double lateral_mm, double axial_mm) {
    const auto place = grid.locate(lateral_mm, axial_mm);
    return frame.amplitude[std::size_t(std::lround(place.sample)) * frame.scanlines + std::lround(place.scanline)];
  };
  const EnvelopeFrame reflection = frameWith({&Effects::reflection});
  EXPECT_GT(at(reflection, 9, 14), 20 * at(reflection, 9, 18));   // surface of the bone against its inside
  EXPECT_GT(at(reflection, 9, 14), 20 * at(reflection, -6, 16));  // and against the lumen
  const EnvelopeFrame absorption = frameWith({&Effects::scattering, &Effects::attenuation, &Effects::transmission});
  EXPECT_GT(at(absorption, -6, 26), 30 * at(absorption, 9, 26));  // behind the vein, behind the bone
  const EnvelopeFrame nothing = frameWith({});
  EXPECT_EQ(*std::max_element(nothing.amplitude.begin(), nothing.amplitude.end()), 0);
}

TEST_P(ThesisLook, DisplaysWithTissueGrayAndVesselsDark) {
  const auto scene = thesisScene(slab(), *loadAcousticTable("thesis"));
  ImagingSettings settings = fullSettings(probe, 256, 800);
  settings.frequency_MHz = 7.5;  // for which the thesis's tissues are
  const EnvelopeFrame frame = thesisFrame(GetParam(), probe, settings, *scene);
  BModeImage image;
  Display(probe, settings).process(frame, image);
  const auto meanGray = [&](double lateral_mm, double axial_mm) {
    double sum = 0;
    int count = 0;
    for (int row = 0; row < image.height; ++row)
      for (int column = 0; column < image.width; ++column)
        if (std::hypot(image.left_mm + column * image.pixel_mm - lateral_mm,
                       image.top_mm + row * image.pixel_mm - axial_mm) < 2)
          sum += image.gray[std::size_t(row) * image.width + column], ++count;
    return sum / count;
  };
  const double muscle = meanGray(-15, 16), lumen = meanGray(-6, 16), shadow = meanGray(9, 28);
  EXPECT_GT(muscle, 20);
  EXPECT_LT(muscle, 110);
  EXPECT_LT(lumen, 0.5 * muscle);
  EXPECT_LT(shadow, 0.5 * muscle);
}

TEST_P(ThesisLook, ElevationPlanesAreAveraged) {
  // Half of the slice's thickness in bone: something between both sides.
  const auto scene = thesisScene(
      paint(gridOver({-21, -4, -2}, {21, 4, 44}, 0.5), [](Vec3 p) { return p.y < 0 ? kMuscle : kBone; }), [] {
        AcousticTable table = plainTissues();
        table.tissues[kBone].echogenicity_dB = 20;
        return table;
      }());
  ImagingSettings settings = thesisSettings(probe, 32, 200);
  settings.effects.scattering = true;
  settings.elevationPlanes = 3;
  const auto line = middleLine(thesisFrame(GetParam(), probe, settings, *scene));
  // Outer planes wholly on either side, the middle one on the boundary: 10 dB, the mean of both levels.
  const double outer = std::exp(-0.5 * 1.2 * 1.2),
               expected = (outer * 1 + std::sqrt(10) + outer * 10) / (1 + 2 * outer);
  EXPECT_NEAR(line[100] / expected, 1, 0.1);
}

TEST(ThesisAgreement, CpuFollowsTheReference) {
  const auto scene = thesisScene(slab(), *loadAcousticTable("thesis"));
  struct Size {
    int scanlines, samples, planes;
  };
  Transform oblique;
  const double c = std::cos(0.3), s = std::sin(0.3);
  oblique.linear = {{Vec3{c, s, 0}, Vec3{-s, c, 0}, Vec3{0, 0, 1}}};
  oblique.offset = {2, 1, 0.5};
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    const Probe probe = *loadProbe(name);
    for (const auto& [scanlines, samples, planes] : {Size{200, 400, 3}, {77, 333, 1}, {16, 64, 5}, {130, 1037, 1}}) {
      ImagingSettings settings = fullSettings(probe, scanlines, samples);
      settings.elevationPlanes = planes;
      for (const Transform& pose : {Transform{}, oblique})
        EXPECT_LT(frameError(thesisFrame("cpu", probe, settings, *scene, pose),
                             thesisFrame("reference", probe, settings, *scene, pose)),
                  0.002)
            << name << ' ' << scanlines << ' ' << samples;
    }
  }
}

TEST(ThesisAgreement, WithoutEachEffectAndWhereThereIsNothing) {
  const Probe probe = *loadProbe("linear");
  const auto scene = thesisScene(slab(), *loadAcousticTable("neck"));
  for (bool Effects::*effect : {&Effects::scattering, &Effects::reflection, &Effects::attenuation,
                                &Effects::transmission, &Effects::speckle, &Effects::texture, &Effects::beam}) {
    ImagingSettings settings = fullSettings(probe, 64, 250);
    settings.effects.*effect = false;
    EXPECT_LT(
        frameError(thesisFrame("cpu", probe, settings, *scene), thesisFrame("reference", probe, settings, *scene)),
        0.002);
  }
  const ImagingSettings settings = fullSettings(probe, 64, 250);
  Transform besides;
  for (const Vec3 offset : {Vec3{25, 0, 0}, Vec3{0, 9, 0}, Vec3{0, 0, 15}, Vec3{0, 0, 40}}) {
    besides.offset = offset;
    EXPECT_LT(frameError(thesisFrame("cpu", probe, settings, *scene, besides),
                         thesisFrame("reference", probe, settings, *scene, besides)),
              0.002)
        << offset.x << ' ' << offset.y << ' ' << offset.z;
  }
  besides.offset = {0, 0, -200};
  const EnvelopeFrame far = thesisFrame("cpu", probe, settings, *scene, besides);
  EXPECT_EQ(*std::max_element(far.amplitude.begin(), far.amplitude.end()), 0);
}

TEST(ThesisAgreement, AnyNumberOfThreadsGivesTheSameImage) {
  const Probe probe = *loadProbe("linear");
  const ImagingSettings settings = fullSettings(probe, 200, 500);
  const auto scene = thesisScene(slab(), *loadAcousticTable("thesis"));
  const tbb::global_control allow(tbb::global_control::max_allowed_parallelism, 8);
  const EnvelopeFrame frame = thesisFrame("cpu", probe, settings, *scene);
  for (const int threads : {1, 2, 5}) {
    tbb::task_arena arena(threads);
    EXPECT_EQ(arena.execute([&] { return thesisFrame("cpu", probe, settings, *scene); }).amplitude, frame.amplitude);
  }
}

TEST(ThesisTime, IsASetting) {
  const auto refusal = [](const nlohmann::json& json) {
    const auto settings = settingsFromJson(json, {});
    return settings ? std::string() : settings.error().message;
  };
  EXPECT_EQ(settingsFromJson(nlohmann::json{{"time_s", 1.5}}, {})->time_s, 1.5);
  EXPECT_NE(refusal({{"time_s", -1}}).find("time_s"), std::string::npos);
  EXPECT_NE(refusal({{"time_s", "now"}}).find("time_s"), std::string::npos);
}

}  // namespace
}  // namespace insonate::test
