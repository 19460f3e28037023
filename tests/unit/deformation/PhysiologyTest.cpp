#include <insonate/deformation/Physiology.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr double kKilopascalPermmHg = 0.133322;

struct Course {
  double mean = 0, low = 1e9, high = -1e9;
  void add(double value, double share) {
    mean += value * share;
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

/// In mmHg, over five minutes: whole numbers of beats and breaths.
struct Watched {
  Course artery, vein;
  explicit Watched(const Physiology& physiology) {
    constexpr int kSamples = 300000;
    for (int i = 0; i < kSamples; ++i) {
      const BloodPressure now = bloodPressureAt(physiology, 300.0 * (i + 0.5) / kSamples);
      artery.add(now.artery_kPa / kKilopascalPermmHg, 1.0 / kSamples);
      vein.add(now.vein_kPa / kKilopascalPermmHg, 1.0 / kSamples);
    }
  }
};

TEST(Physiology, PulseGoesFromDiastolicToSystolicWithTheMeanAThirdUp) {
  const Watched watched{Physiology{}};
  EXPECT_NEAR(watched.artery.low, 80, 0.01);
  EXPECT_NEAR(watched.artery.high, 120, 0.01);
  EXPECT_NEAR(watched.artery.mean, 80 + 40.0 / 3, 0.02);
}

TEST(Physiology, BreathSwingsTheVeinAboutItsMean) {
  const Watched watched{Physiology{}};
  EXPECT_NEAR(watched.vein.mean, 4, 0.001);
  EXPECT_NEAR(watched.vein.low, 4 - 1.25, 0.001);
  EXPECT_NEAR(watched.vein.high, 4 + 1.25, 0.001);
}

TEST(Physiology, RepeatsWithHeartAndBreath) {
  Physiology physiology;
  physiology.heartRate_perMin = 75;  // 0.8 s
  physiology.breathing_perMin = 12;  // 5 s
  for (double time_s = -7; time_s < 7; time_s += 0.173) {
    const BloodPressure now = bloodPressureAt(physiology, time_s);
    EXPECT_NEAR(now.artery_kPa, bloodPressureAt(physiology, time_s + 0.8).artery_kPa, 1e-9);
    EXPECT_NEAR(now.vein_kPa, bloodPressureAt(physiology, time_s + 5).vein_kPa, 1e-9);
  }
  EXPECT_GT(std::abs(bloodPressureAt(physiology, 0).artery_kPa - bloodPressureAt(physiology, 0.4).artery_kPa), 0.5);
  EXPECT_GT(std::abs(bloodPressureAt(physiology, 0).vein_kPa - bloodPressureAt(physiology, 2).vein_kPa), 0.1);
}

TEST(Physiology, IsContinuous) {
  const Physiology physiology;
  BloodPressure last = bloodPressureAt(physiology, 0);
  for (double time_s = 0.001; time_s < 10; time_s += 0.001) {
    const BloodPressure now = bloodPressureAt(physiology, time_s);
    EXPECT_LT(std::abs(now.artery_kPa - last.artery_kPa), 0.1);
    EXPECT_LT(std::abs(now.vein_kPa - last.vein_kPa), 0.001);
    last = now;
  }
}

TEST(Physiology, TheCarotidRisesFastFallsSlowlyAndHasADicroticWave) {
  Physiology physiology;
  physiology.heartRate_perMin = 60;
  const auto artery = [&](double time_s) { return bloodPressureAt(physiology, time_s).artery_kPa; };
  int turns = 0;
  for (int i = 0; i < 998; ++i)
    turns += (artery(i / 1000.0) < artery((i + 1) / 1000.0)) != (artery((i + 1) / 1000.0) < artery((i + 2) / 1000.0));
  EXPECT_EQ(turns, 3);  // systolic peak, dicrotic notch, dicrotic peak
  EXPECT_GT(artery(0.15), artery(0.1));
  EXPECT_GT(artery(0.15), artery(0.2));
}

TEST(Physiology, HeadDownFillsTheVeinAndHeadUpEmptiesIt) {
  Physiology physiology;
  double last_kPa = -1;
  for (double tilt_deg = -45; tilt_deg <= 45; tilt_deg += 1) {
    physiology.tilt_deg = tilt_deg;
    const BloodPressure mean = meanBloodPressure(physiology);
    EXPECT_GE(mean.vein_kPa, last_kPa) << tilt_deg;
    if (tilt_deg > -10) {
      EXPECT_GT(mean.vein_kPa, last_kPa) << tilt_deg;
    }
    last_kPa = mean.vein_kPa;
  }
  physiology.tilt_deg = 15;  // 22 cm of blood, times sin 15 degrees: 4.44 mmHg
  EXPECT_NEAR(meanBloodPressure(physiology).vein_kPa / kKilopascalPermmHg, 4 + 4.44, 0.01);
  EXPECT_NEAR(meanBloodPressure(physiology).artery_kPa / kKilopascalPermmHg, 93.33 + 3.03, 0.01);
  physiology.tilt_deg = -45;
  EXPECT_EQ(meanBloodPressure(physiology).vein_kPa, 0);
  EXPECT_EQ(bloodPressureAt(physiology, 1).vein_kPa, 0);
}

/// The groin, 350 mm below the heart and 280 mm below the point whose venous pressure does not change.
Physiology ofTheGroin(double tilt_deg = 0) {
  Physiology physiology;
  physiology.siteAboveHeart_mm = -350, physiology.tilt_deg = tilt_deg;
  return physiology;
}

TEST(Physiology, HeadUpFillsTheVeinOfTheGroinAndHeadDownEmptiesIt) {
  const auto vein_mmHg = [](double tilt_deg) {
    return meanBloodPressure(ofTheGroin(tilt_deg)).vein_kPa / kKilopascalPermmHg;
  };
  EXPECT_NEAR(vein_mmHg(0), 4, 0.001) << "as in the CT";
  EXPECT_NEAR(vein_mmHg(-15), 4 + 5.65, 0.01);  // 28 cm of blood, times sin 15 degrees
  EXPECT_NEAR(vein_mmHg(-20), 4 + 7.47, 0.01);
  EXPECT_NEAR(vein_mmHg(4), 4 - 1.52, 0.01);
  EXPECT_NEAR(vein_mmHg(20), 2, 0.001) << "the abdomen keeps the veins of the legs from emptying";
  EXPECT_NEAR(meanBloodPressure(ofTheGroin(15)).artery_kPa / kKilopascalPermmHg, 93.33 - 7.07, 0.01);
}

/// In the neck, inspiration empties the vein; in the groin, it raises the pressure of the abdomen.
TEST(Physiology, InspirationWidensTheVeinOfTheGroin) {
  const double outwards_s = 0, inwards_s = 0.4 * 60 / 14;  // end of expiration, end of inspiration
  EXPECT_NEAR(respirationAt({}, inwards_s), -0.5, 1e-9);
  const auto swing_mmHg = [&](const Physiology& of) {
    return (bloodPressureAt(of, inwards_s).vein_kPa - bloodPressureAt(of, outwards_s).vein_kPa) / kKilopascalPermmHg;
  };
  EXPECT_NEAR(swing_mmHg({}), -2.5, 1e-6);
  EXPECT_NEAR(swing_mmHg(ofTheGroin()), 0.4 * 2.5, 1e-6);
  Physiology ventilated = ofTheGroin();
  ventilated.breathingSwing_mmHg = -2.5;
  EXPECT_NEAR(swing_mmHg(ventilated), 0.4 * 2.5, 1e-6) << "a ventilator raises it, too";
}

TEST(Physiology, TheMeanIsThatOfTheCourse) {
  Physiology physiology;
  for (const double tilt_deg : {-12.0, 0.0, 20.0}) {
    physiology.tilt_deg = tilt_deg;  // at -12 degrees the vein collapses during a part of the breath
    const Watched watched{physiology};
    const BloodPressure mean = meanBloodPressure(physiology);
    EXPECT_NEAR(mean.vein_kPa / kKilopascalPermmHg, watched.vein.mean, 0.001) << tilt_deg;
    EXPECT_NEAR(mean.artery_kPa / kKilopascalPermmHg, watched.artery.mean, 0.02) << tilt_deg;
  }
}

TEST(Physiology, AtRestItIsWhatTheMeasuredTissueWasImagedUnder) {
  const MechanicalTable measured = *loadMechanicalTable("measured");
  const BloodPressure mean = meanBloodPressure({});
  EXPECT_NEAR(mean.artery_kPa, measured.of(kArtery).pressure_kPa, 0.1);
  EXPECT_NEAR(mean.vein_kPa, measured.of(kVein).pressure_kPa, 0.005);
}

TEST(Physiology, WithoutBeatAndBreathItStandsStillAtTheMean) {
  Physiology physiology;
  physiology.heartRate_perMin = physiology.breathing_perMin = 0;
  for (const double time_s : {0.0, 0.31, 7.7}) {
    EXPECT_NEAR(bloodPressureAt(physiology, time_s).artery_kPa, meanBloodPressure({}).artery_kPa, 1e-12);
    EXPECT_NEAR(bloodPressureAt(physiology, time_s).vein_kPa, 4 * kKilopascalPermmHg, 1e-12);
  }
}

TEST(Physiology, AVentilatorTurnsTheBreathRound) {
  Physiology physiology;
  const double atStart = bloodPressureAt(physiology, 0).vein_kPa;
  physiology.breathingSwing_mmHg = -physiology.breathingSwing_mmHg;
  EXPECT_LT(bloodPressureAt(physiology, 0).vein_kPa, atStart);
}

TEST(Physiology, ATimeThatIsNoneIsTheStart) {
  for (const double time_s : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(bloodPressureAt({}, time_s).artery_kPa, bloodPressureAt({}, 0).artery_kPa);
    EXPECT_EQ(bloodPressureAt({}, time_s).vein_kPa, bloodPressureAt({}, 0).vein_kPa);
  }
  const BloodPressure late = bloodPressureAt({}, 1e18);
  EXPECT_TRUE(std::isfinite(late.artery_kPa) && std::isfinite(late.vein_kPa));
}

std::string refusalOf(double Physiology::*field, double value) {
  Physiology physiology;
  physiology.*field = value;
  const auto ok = checkPhysiology(physiology);
  EXPECT_FALSE(ok) << value;
  return ok ? "" : ok.error().message;
}

TEST(PhysiologyCheck, TakesWhatPatientsHave) {
  EXPECT_TRUE(checkPhysiology({}));
  Physiology shock;
  shock.centralVenous_mmHg = -2;
  shock.systolic_mmHg = 60;
  shock.diastolic_mmHg = 30;
  shock.heartRate_perMin = 150;
  EXPECT_TRUE(checkPhysiology(shock));
  Physiology still;
  still.heartRate_perMin = still.breathing_perMin = 0;
  EXPECT_TRUE(checkPhysiology(still));
}

TEST(PhysiologyCheck, RefusesWithFieldValueAndRange) {
  EXPECT_THAT(refusalOf(&Physiology::centralVenous_mmHg, 31),
              AllOf(HasSubstr("centralVenous_mmHg"), HasSubstr("31"), HasSubstr("-5 to 30")));
  EXPECT_THAT(refusalOf(&Physiology::systolic_mmHg, 300), HasSubstr("systolic_mmHg"));
  EXPECT_THAT(refusalOf(&Physiology::diastolic_mmHg, 0), HasSubstr("diastolic_mmHg"));
  EXPECT_THAT(refusalOf(&Physiology::diastolic_mmHg, 120), AllOf(HasSubstr("above"), HasSubstr("120")));
  EXPECT_THAT(refusalOf(&Physiology::heartRate_perMin, 10), AllOf(HasSubstr("20 to 250"), HasSubstr("0 for none")));
  EXPECT_THAT(refusalOf(&Physiology::breathing_perMin, -3), HasSubstr("breathing_perMin"));
  EXPECT_THAT(refusalOf(&Physiology::breathingSwing_mmHg, 25), HasSubstr("breathingSwing_mmHg"));
  EXPECT_THAT(refusalOf(&Physiology::tilt_deg, 60), HasSubstr("-45 to 45"));
  EXPECT_THAT(refusalOf(&Physiology::siteAboveHeart_mm, -700), HasSubstr("siteAboveHeart_mm"));
  EXPECT_THAT(refusalOf(&Physiology::indifferenceFromHeart_mm, -1), HasSubstr("indifferenceFromHeart_mm"));
  EXPECT_THAT(refusalOf(&Physiology::lungSlide_mm, -1), HasSubstr("lungSlide_mm"));
}

TEST(Physiology, TheLungSlidesWithRespirationAndNotWithAPneumothorax) {
  Physiology physiology;
  double low = 0, high = 0;
  for (double time_s = 0; time_s < 10; time_s += 0.01) {
    const double slide_mm = lungSlideAt_mm(physiology, time_s);
    EXPECT_NEAR(slide_mm, physiology.lungSlide_mm * respirationAt(physiology, time_s), 1e-12);
    low = std::min(low, slide_mm), high = std::max(high, slide_mm);
  }
  EXPECT_NEAR(high - low, physiology.lungSlide_mm, 0.01);
  physiology.lungSlide_mm = 0;
  EXPECT_EQ(lungSlideAt_mm(physiology, 1.3), 0);
  physiology = {};
  physiology.breathing_perMin = 0;
  EXPECT_EQ(lungSlideAt_mm(physiology, 1.3), 0);
}

TEST(PhysiologyCheck, RefusesNumbersThatAreNone) {
  for (const auto field : {&Physiology::centralVenous_mmHg, &Physiology::systolic_mmHg, &Physiology::diastolic_mmHg,
                           &Physiology::heartRate_perMin, &Physiology::breathing_perMin,
                           &Physiology::breathingSwing_mmHg, &Physiology::tilt_deg, &Physiology::siteAboveHeart_mm,
                           &Physiology::indifferenceFromHeart_mm, &Physiology::lungSlide_mm})
    for (const double value : {std::nan(""), std::numeric_limits<double>::infinity()})
      EXPECT_FALSE(refusalOf(field, value).empty());
}

}  // namespace
}  // namespace insonate
