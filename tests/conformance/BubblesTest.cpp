#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <cmath>

namespace insonate::test {
namespace {

class Bubbles : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(Bubbles);

constexpr double kFocus_mm = 20;

/// Bubbles alone: the tissue has no echoes.
struct BubbleBench {
  Probe probe = probeNamed("linear");
  ImagingSettings settings = silentSettings(probe, 256, 1000, 3);
  ScenePtr scene;

  explicit BubbleBench(double echogenicity_dB = -200) {
    settings.effects.scattering = true;
    AcousticTable table = plainTable();
    for (AcousticTissue& tissue : table.tissues) tissue.echogenicity_dB = echogenicity_dB;
    scene = evenScene(probe, settings, table);
  }
  BeamGrid grid() const { return {probe, settings}; }
  EnvelopeFrame with(const std::string& engine, const std::vector<Bubble>& bubbles,
                     const PlaneDisplacement& displacement = {}) const {
    return renderWithBubbles(engine, probe, settings, *scene, bubbles, displacement);
  }
};

TEST_P(Bubbles, ABubbleIsAPointOfItsAmplitude) {
  const BubbleBench bench;
  const BeamGrid grid = bench.grid();
  for (const double x_mm : {-9.0, 0.05, 7.3}) {
    const EnvelopeFrame frame = bench.with(GetParam(), {{{x_mm, 0, kFocus_mm}, 10}});
    const int line = int(std::lround(grid.locate(x_mm, kFocus_mm).scanline));
    const Peak down = peakOf(scanline(frame, line));
    EXPECT_NEAR(grid.range_mm(down.index), kFocus_mm, 0.05) << x_mm;
    EXPECT_NEAR(down.value, 10, 1.5) << x_mm << ", between gates";
    EXPECT_NEAR(peakOf(acrossLines(frame, int(std::lround(down.index)))).index, line, 1) << x_mm;
  }
}

TEST_P(Bubbles, BesideTheSliceABubbleIsFaint) {
  const BubbleBench bench;
  const auto brightest = [&](double beside_mm) {
    return peakOf(scanline(bench.with(GetParam(), {{{0, beside_mm, kFocus_mm}, 10}}), 128)).value;
  };
  const double middle = brightest(0);
  EXPECT_LT(brightest(0.8), 0.8 * middle);
  EXPECT_LT(brightest(5), 0.01 * middle);
}

TEST_P(Bubbles, MoveWithTheTissue) {
  const BubbleBench bench;
  // A displacement from where tissue is displayed to where it rests.
  const PlaneDisplacement shifted =
      displacementOver(bench.probe, bench.settings, 1, [](double, double) { return shiftBy(2, -3); });
  const EnvelopeFrame there = bench.with(GetParam(), {{{4, 0, kFocus_mm}, 10}}, shifted);
  EXPECT_LT(relativeError(there, bench.with(GetParam(), {{{2, 0, kFocus_mm + 3}, 10}})), 0.02);
}

TEST_P(Bubbles, AgreeWithTheReference) {
  const BubbleBench bench(0);
  std::vector<Bubble> bubbles;
  for (int i = 0; i < 60; ++i)
    bubbles.push_back({{-14 + 0.47 * i, 0.03 * (i % 40), 8 + 21.0 * ((i * 37) % 60) / 60}, 2.0 + i % 9});
  const EnvelopeFrame frame = bench.with(GetParam(), bubbles);
  EXPECT_LT(relativeError(frame, bench.with("reference", bubbles)), 0.005);
  EXPECT_GT(relativeError(frame, bench.with(GetParam(), {})), 0.1) << "they are brighter than the tissue";
}

/// Also with two angles, whose gaps to the skin the compounding engine computes.
TEST_P(Bubbles, AreCompounded) {
  BubbleBench bench;
  bench.settings.compoundingAngles = 3;
  const auto engine = makeEngineFor(GetParam(), bench.probe, bench.settings);
  ASSERT_TRUE(engine);
  (*engine)->prepare(bench.probe, bench.settings);
  const std::vector<Bubble> bubbles{{{0, 0, kFocus_mm}, 10}};
  EnvelopeFrame frame;
  (*engine)->render(*bench.scene, {}, {}, Instruments(nullptr, {}, bubbles), frame);
  EXPECT_NEAR(bench.grid().range_mm(peakOf(scanline(frame, 128)).index), kFocus_mm, 0.1);
  EXPECT_GT(peakOf(scanline(frame, 128)).value, 5);
}

TEST_P(Bubbles, WithoutBubblesNothingChanges) {
  const BubbleBench bench(0);
  EXPECT_EQ(bench.with(GetParam(), {}).amplitude, render(bench.probe, bench.settings, bench.scene).amplitude);
  EXPECT_EQ(bench.with(GetParam(), {{{0, 60, kFocus_mm}, 10}, {{90, 0, 20}, 10}}).amplitude,
            render(bench.probe, bench.settings, bench.scene).amplitude)
      << "bubbles beside the image";
}

}  // namespace
}  // namespace insonate::test
