#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/Electrocardiogram.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace insonate {
namespace {

/// Plays an ECG in steps of a window's timer, and keeps all beats.
class Played {
 public:
  void play(double until_s, HeartRhythm rhythm, double rate_perMin = 75) {
    for (; now_s < until_s; now_s += 0.04) {
      ecg.advance(now_s, rhythm, rate_perMin);
      for (const auto& beat : ecg.beats())
        if (beats.empty() || beat.time_s > beats.back().time_s) beats.push_back(beat);
    }
  }
  std::vector<Electrocardiogram::Beat> between(double from_s, double to_s) const {
    std::vector<Electrocardiogram::Beat> some;
    for (const auto& beat : beats)
      if (beat.time_s >= from_s && beat.time_s < to_s) some.push_back(beat);
    return some;
  }

  Electrocardiogram ecg;
  std::vector<Electrocardiogram::Beat> beats;
  double now_s = 0;
};

/// Each R wave comes shortly before the arterial pressure rises.
TEST(Electrocardiogram, TheRWavePrecedesThePulse) {
  Physiology physiology;
  physiology.heartRate_perMin = 75;
  Played played;
  played.play(20, HeartRhythm::Sinus);
  ASSERT_EQ(played.between(0, 20).size(), 25u);
  for (const auto& beat : played.between(1, 20)) {
    EXPECT_FALSE(beat.isWide);
    EXPECT_NEAR(heartPhaseAt(physiology, beat.time_s + 0.15 + 1e-6), 0, 0.001);
  }
  EXPECT_NEAR(*played.ecg.rate_perMin(played.now_s), 75, 0.01);
}

/// At the R wave the voltage has its maximum, and between T and P it is almost 0.
TEST(Electrocardiogram, TheCurveHasTheShapeOfABeat) {
  Played played;
  played.play(10, HeartRhythm::Sinus, 60);
  const double r_s = played.between(6, 8).front().time_s;
  EXPECT_NEAR(played.ecg.voltage_mV(r_s), 1.1, 0.1);
  EXPECT_NEAR(played.ecg.voltage_mV(r_s - 0.17), 0.12, 0.02) << "P";
  EXPECT_NEAR(played.ecg.voltage_mV(r_s + 0.27), 0.28, 0.02) << "T";
  EXPECT_NEAR(played.ecg.voltage_mV(r_s + 0.55), 0, 0.01);
}

/// A premature beat lies nearer to the beat before it than to the one after it, and the rhythm stays that of the pulse.
TEST(Electrocardiogram, ExtraBeatsArePrematureAndFollowedByAPause) {
  Played played;
  played.play(5, HeartRhythm::Sinus);
  played.play(15, HeartRhythm::ExtraBeats);
  const auto beats = played.between(6, 15);
  ASSERT_GT(beats.size(), 8u);
  for (std::size_t i = 1; i + 1 < beats.size(); ++i) {
    EXPECT_NE(beats[i].isWide, beats[i - 1].isWide);
    if (!beats[i].isWide) continue;
    EXPECT_NEAR(beats[i].time_s - beats[i - 1].time_s, 0.6 * 0.8, 0.01);
    EXPECT_NEAR(beats[i + 1].time_s - beats[i - 1].time_s, 2 * 0.8, 0.01) << "one normal beat is left out";
  }
}

TEST(Electrocardiogram, ATachycardiaBeginsAndEnds) {
  Played played;
  played.play(5, HeartRhythm::Sinus);
  played.play(8, HeartRhythm::Tachycardia);
  EXPECT_NEAR(*played.ecg.rate_perMin(played.now_s), 180, 1);
  played.play(14, HeartRhythm::Sinus);
  for (const auto& beat : played.between(9, 14)) EXPECT_FALSE(beat.isWide);
  EXPECT_NEAR(*played.ecg.rate_perMin(played.now_s), 75, 0.1);
}

TEST(Electrocardiogram, WithoutAPulseTheLineIsFlat) {
  Played played;
  played.play(5, HeartRhythm::Sinus, 0);
  EXPECT_TRUE(played.beats.empty());
  EXPECT_EQ(played.ecg.voltage_mV(3), 0);
  EXPECT_FALSE(played.ecg.rate_perMin(5));
}

/// A case that was closed, or a long pause: no beats of the time between.
TEST(Electrocardiogram, AJumpBeginsANewOne) {
  Played played;
  played.play(3, HeartRhythm::Sinus);
  played.ecg.advance(1000, HeartRhythm::Sinus, 75);
  for (const auto& beat : played.ecg.beats()) EXPECT_GT(beat.time_s, 998);
  played.ecg.advance(5, HeartRhythm::Sinus, 75);
  for (const auto& beat : played.ecg.beats()) EXPECT_LT(beat.time_s, 6);
}

}  // namespace
}  // namespace insonate
