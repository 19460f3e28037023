#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <cmath>

namespace insonate::test {
namespace {

class EachEffect : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(EachEffect);

constexpr int kLines = 96, kSamples = 400;

/// Tissue with a vessel, and gas below, that shows every effect.
struct Bench {
  Probe probe = probeNamed("linear");
  ImagingSettings settings = settingsFor(probe);
  AcousticTable table = plainTable();
  LabelPhantom phantom = paint(gridOver({-21, -5.6, -14}, {21, 5.6, 56}, 0.7), [](Vec3 p) {
    if (std::hypot(p.x - 5, p.z - 14) < 5) return kArtery;
    return p.x < -4 && p.z > 24 ? kAirway : p.z > 30 ? kBone : kMuscle;
  });

  Bench() {
    settings.scanlines = kLines, settings.samples = kSamples, settings.conformingContact = false;
    for (AcousticTissue& tissue : table.tissues) tissue.attenuation_dBpcmMHz = 0.5;
    table.tissues[kMuscle].texture = Texture::Septa;
    table.tissues[kMuscle].textureStrength_dB = 12;
    AcousticTissue& artery = table.tissues[kArtery];
    artery.echogenicity_dB = -24, artery.vessel = true;
    artery.layers = {{0, 0.6, 10, 0.8, 0.3}};
    table.tissues[kBone].impedance_MRayl = 5;
    table.tissues[kAirway].impedance_MRayl = 0.0004;
    table.tissues[kAirway].echogenicity_dB = -60;
    table.tissues[kAirway].gas = true;
  }
  ScenePtr scene(const AcousticTable& tissues) const {
    return sceneOf(phantom, tissues, regionAround(probe, settings));
  }
  EnvelopeFrame with(const std::string& engine, const Effects& effects, const ScenePtr& scene) const {
    ImagingSettings changed = settings;
    changed.effects = effects;
    return renderWith(engine, probe, changed, *scene);
  }
};

TEST_P(EachEffect, ShowsInASceneThatHasWhatItNeeds) {
  const Bench bench;
  const ScenePtr scene = bench.scene(bench.table);
  const EnvelopeFrame all = bench.with(GetParam(), {}, scene);
  for (bool Effects::*effect :
       {&Effects::scattering, &Effects::reflection, &Effects::attenuation, &Effects::transmission, &Effects::speckle,
        &Effects::layers, &Effects::texture, &Effects::beam, &Effects::reverberation, &Effects::edgeShadow}) {
    Effects others;
    others.*effect = false;
    EXPECT_FALSE(identical(all, bench.with(GetParam(), others, scene)));
  }
  Effects clear;
  clear.clutter = false;
  EXPECT_TRUE(identical(all, bench.with(GetParam(), clear, scene))) << "haze belongs to the display";
}

TEST_P(EachEffect, ChangesNothingWhereItsCauseIsMissing) {
  Bench bench;
  bench.phantom = paint(bench.phantom.labels.geometry, [](Vec3) { return kSoftTissue; });
  const ScenePtr scene = bench.scene(plainTable());
  const EnvelopeFrame all = bench.with(GetParam(), {}, scene);
  for (bool Effects::*effect : {&Effects::reflection, &Effects::attenuation, &Effects::transmission, &Effects::layers,
                                &Effects::texture, &Effects::reverberation, &Effects::edgeShadow}) {
    Effects others;
    others.*effect = false;
    EXPECT_TRUE(identical(all, bench.with(GetParam(), others, scene)));
  }
}

TEST_P(EachEffect, OffIsTheSameAsATableWithoutIt) {
  const Bench bench;
  const ScenePtr scene = bench.scene(bench.table);
  const auto compare = [&](bool Effects::*effect, const auto& strip, const char* what) {
    Effects off;
    off.*effect = false;
    AcousticTable without = bench.table;
    for (AcousticTissue& tissue : without.tissues) strip(tissue);
    const ScenePtr stripped = bench.scene(without);
    const EnvelopeFrame a = bench.with(GetParam(), off, scene), b = bench.with(GetParam(), off, stripped);
    EXPECT_LT(relativeError(a, b), 1e-6) << what << ": what is off must not matter";
    EXPECT_LT(relativeError(bench.with(GetParam(), {}, stripped), b), 1e-6)
        << what << ": off is as if it were not there";
  };
  compare(
      &Effects::attenuation, [](AcousticTissue& t) { t.attenuation_dBpcmMHz = 0, t.vessel = false; }, "attenuation");
  compare(
      &Effects::layers, [](AcousticTissue& t) { t.layers.clear(); }, "layers");
  compare(
      &Effects::texture, [](AcousticTissue& t) { t.texture = Texture::None; }, "texture");
  compare(
      &Effects::edgeShadow, [](AcousticTissue& t) { t.vessel = false; }, "edge shadow");
  compare(
      &Effects::reverberation, [](AcousticTissue& t) { t.gas = false; }, "reverberation");
}

TEST_P(EachEffect, WithoutScatteringOrReflectionNothingComesBack) {
  const Bench bench;
  Effects silent;
  silent.scattering = silent.reflection = false;
  EXPECT_EQ(largest(bench.with(GetParam(), silent, bench.scene(bench.table))), 0);
}

TEST_P(EachEffect, WithoutScatteringOnlyBoundariesRemain) {
  const Bench bench;
  Effects boundaries;
  boundaries.scattering = boundaries.reverberation = false;
  const EnvelopeFrame frame = bench.with(GetParam(), boundaries, bench.scene(bench.table));
  const auto level = [&](double x_mm, double z_mm) {
    const auto at = BeamGrid(bench.probe, bench.settings).locate(x_mm, z_mm);
    return frame.amplitude[std::size_t(std::lround(at.sample)) * kLines + std::lround(at.scanline)];
  };
  EXPECT_GT(level(0, 30), 1) << "surface of the bone";
  EXPECT_LT(level(0, 6), 1e-6) << "inside tissue";
}

TEST_P(EachEffect, UniformScatteringHasTheMeanPowerOfSpeckle) {
  const Probe probe = probeNamed("linear");
  const ImagingSettings settings = uniformSettings(probe, kLines, kSamples, 3);
  const EnvelopeFrame frame = render(probe, settings, evenScene(probe, settings));
  const auto inner = valuesIn(frame, {40, 360, 10, 86});
  EXPECT_NEAR(mean(inner), 1, 0.01);
  EXPECT_LT(standardDeviation(inner), 0.01);
}

TEST_P(EachEffect, WithoutTheBeamSpeckleIsFinerButAsStrong) {
  const Probe probe = probeNamed("linear");
  ImagingSettings settings = speckleSettings(probe, 256, kSamples, 3);
  const ScenePtr scene = evenScene(probe, settings);
  const EnvelopeFrame blurred = render(probe, settings, scene);
  settings.effects.beam = false;
  const EnvelopeFrame sharp = render(probe, settings, scene);
  const auto neighbors = [](const EnvelopeFrame& frame) {
    return correlation(valuesIn(frame, {40, 360, 20, 230}), valuesIn(frame, {40, 360, 22, 232}));
  };
  EXPECT_LT(neighbors(sharp), neighbors(blurred) - 0.2);
  EXPECT_NEAR(decibel(rms(valuesIn(sharp, {40, 360, 20, 230}))), 0, 0.5);
}

TEST_P(EachEffect, BehindGasTheTissueAboveComesAgain) {
  const Bench bench;
  Effects quiet;
  quiet.reverberation = false;
  const Window behind{int(27.0 / 40 * kSamples), int(36.0 / 40 * kSamples), 5, 30};
  const double dead = rms(valuesIn(bench.with(GetParam(), quiet, bench.scene(bench.table)), behind));
  const double dirty = rms(valuesIn(bench.with(GetParam(), {}, bench.scene(bench.table)), behind));
  EXPECT_LT(dead, 1e-4);
  EXPECT_GT(dirty, 1e-3);
}

}  // namespace
}  // namespace insonate::test
