#include "unit/ultrasound/ThesisRig.h"

#include <numbers>
#include <vector>

namespace insonate::test {
namespace {

constexpr double kReflector_dB = 50;  // echo of a perfect reflector over unit speckle

class ThesisEquations : public ThesisEngines {};
INSTANTIATE_TEST_SUITE_P(Engines, ThesisEquations, testing::ValuesIn(engineNames()), thesisEngineName);

/// Muscle above a plane at 20 mm, bone below, the plane's normal turned by an angle about the elevation axis.
LabelPhantom halves(double angle_deg = 0) {
  const double angle = angle_deg * std::numbers::pi / 180;
  return paint(gridOver({-21, -3, -2}, {21, 3, 44}, 0.5),
               [angle](Vec3 p) { return (p.z - 20) * std::cos(angle) + p.x * std::sin(angle) < 0 ? kMuscle : kBone; });
}

AcousticTable twoImpedances(double above_MRayl, double below_MRayl) {
  AcousticTable table = plainTissues();
  table.tissues[kMuscle].impedance_MRayl = above_MRayl;
  table.tissues[kBone].impedance_MRayl = below_MRayl;
  return table;
}

double peakReflection(const std::string& engine, const Probe& probe, double angle_deg, double z1, double z2) {
  ImagingSettings settings = thesisSettings(probe);
  settings.effects.reflection = true;
  const auto scene = thesisScene(halves(angle_deg), twoImpedances(z1, z2));
  const auto line = middleLine(thesisFrame(engine, probe, settings, *scene));
  return *std::max_element(line.begin(), line.end()) / std::pow(10, kReflector_dB / 20);
}

TEST_P(ThesisEquations, ReflectionIsTheChangeOfImpedance) {
  // Equation 6 square to the beam: d . gradZ / (2 Z), over the interface (Z2 - Z1) / (Z2 + Z1).
  for (const auto& [z1, z2] : {std::pair{1.60, 1.70}, {1.70, 1.60}, {1.36, 1.65}, {1.65, 5.95}})
    EXPECT_NEAR(peakReflection(GetParam(), probe, 0, z1, z2) / (std::abs(z2 - z1) / (z2 + z1)), 1, 0.1)
        << z1 << " to " << z2;
}

TEST_P(ThesisEquations, ReflectionFallsWithTheCosine) {
  // The dot product of equation 6: amplitude cos(theta), intensity its square.
  const double square = peakReflection(GetParam(), probe, 0, 1.6, 1.7);
  for (const double angle_deg : {15.0, 30.0, 45.0, 60.0})
    EXPECT_NEAR(peakReflection(GetParam(), probe, angle_deg, 1.6, 1.7) / square,
                std::cos(angle_deg * std::numbers::pi / 180), 0.08)
        << angle_deg << " degrees";
}

TEST_P(ThesisEquations, EqualImpedanceReflectsNothing) {
  EXPECT_LT(peakReflection(GetParam(), probe, 20, 1.6, 1.6), 1e-6);
}

TEST_P(ThesisEquations, AbsorptionIsTwiceAlphaTimesFrequency) {
  // Equation 7 there and back: muscle 0.5 dB/cm/MHz, below 20 mm bone 1.5.
  AcousticTable table = plainTissues();
  table.tissues[kMuscle].attenuation_dBpcmMHz = 0.5;
  table.tissues[kBone].attenuation_dBpcmMHz = 1.5;
  const auto scene = thesisScene(halves(), table);
  for (const double frequency_MHz : {5.0, 10.0}) {
    ImagingSettings settings = thesisSettings(probe);
    settings.frequency_MHz = frequency_MHz;
    settings.effects.scattering = settings.effects.attenuation = true;
    const auto line = middleLine(thesisFrame(GetParam(), probe, settings, *scene));
    const BeamGrid grid(probe, settings);
    const auto level_dB = [&](double range_mm) {
      return decibel(line[static_cast<std::size_t>(std::lround(grid.sampleAt(range_mm)))]);
    };
    EXPECT_NEAR(level_dB(5) - level_dB(15), 2 * 0.5 * frequency_MHz, 0.02 * frequency_MHz);
    EXPECT_NEAR(level_dB(25) - level_dB(35), 2 * 1.5 * frequency_MHz, 0.06 * frequency_MHz);
    // 5 mm of each on the way.
    EXPECT_NEAR(level_dB(15) - level_dB(25), (0.5 + 1.5) * frequency_MHz, 0.1 * frequency_MHz);
  }
}

TEST_P(ThesisEquations, BoundariesTakeWhatTheyReflect) {
  // Equation 8: (1 - R^2) there and back. 1.6 to 2.4 MRayl: R = 0.2, 0.355 dB; 1.6 to 5.6: R = 0.556, 3.21 dB.
  for (const auto& [below_MRayl, loss_dB] : {std::pair{2.4, 0.3546}, {5.6, 3.209}}) {
    ImagingSettings settings = thesisSettings(probe);
    settings.effects.scattering = settings.effects.transmission = true;
    const auto scene = thesisScene(halves(), twoImpedances(1.6, below_MRayl));
    const auto line = middleLine(thesisFrame(GetParam(), probe, settings, *scene));
    const BeamGrid grid(probe, settings);
    EXPECT_NEAR(decibel(line[static_cast<std::size_t>(grid.sampleAt(10))]), 0, 0.001);
    EXPECT_NEAR(-decibel(line[static_cast<std::size_t>(grid.sampleAt(30))]), loss_dB, 0.1 * loss_dB);
  }
}

TEST_P(ThesisEquations, CtShowsWithinAStructure) {
  // 100 HU on a slope of 10 mm, impedance 5 % per 100 HU: a change of ln Z of 0.05 per 10 mm.
  AcousticTable table = plainTissues();
  table.tissues[kMuscle].ctImpedancePer100HU = 0.05;
  table.tissues[kMuscle].ctEchogenicity_dBper100HU = 6;
  const auto ramp = [](Vec3 p) { return std::lround(std::clamp((p.z - 20) * 10, -50.0, 50.0)); };
  const auto scene = thesisScene(paint(
                                     gridOver({-21, -3, 0}, {21, 3, 40}, 0.5), [](Vec3) { return kMuscle; }, ramp),
                                 table);
  ImagingSettings settings = thesisSettings(probe);
  const BeamGrid grid(probe, settings);
  const auto at = [&](const std::vector<double>& line, double range_mm) {
    return line[static_cast<std::size_t>(grid.sampleAt(range_mm))];
  };
  settings.effects.texture = settings.effects.reflection = true;
  const auto edges = middleLine(thesisFrame(GetParam(), probe, settings, *scene));
  const double interface_mm = 0.8 / 1.875;  // width over which a structure's edge has its greatest slope
  EXPECT_NEAR(at(edges, 22) / std::pow(10, kReflector_dB / 20) / (0.005 * interface_mm / 2), 1, 0.05);
  EXPECT_LT(at(edges, 35), 0.02 * at(edges, 22));
  settings.effects.reflection = false, settings.effects.scattering = true;
  const auto tissue = middleLine(thesisFrame(GetParam(), probe, settings, *scene));
  EXPECT_NEAR(decibel(at(tissue, 35)) - decibel(at(tissue, 5)), 6, 0.1);
  settings.effects.texture = false;
  const auto plain = middleLine(thesisFrame(GetParam(), probe, settings, *scene));
  EXPECT_NEAR(decibel(at(plain, 35)), 0, 0.001);
}

TEST_P(ThesisEquations, BlurTrailsBehindAnEdgeAndSpreadsAcross) {
  ImagingSettings settings = thesisSettings(probe, 128);
  settings.effects.reflection = true;
  const auto scene = thesisScene(halves(), twoImpedances(1.6, 1.7));
  const auto sharp = middleLine(thesisFrame(GetParam(), probe, settings, *scene));
  settings.effects.beam = true;
  const auto blurred = middleLine(thesisFrame(GetParam(), probe, settings, *scene));
  const BeamGrid grid(probe, settings);
  // Behind the edge the echo falls by e over 0.8 FWHM of the pulse, of 1.27 wavelengths.
  const double tail_mm = 0.8 * 1.27 * 1.54 / settings.frequency_MHz;
  const auto at = [&](double range_mm) { return blurred[static_cast<std::size_t>(grid.sampleAt(range_mm))]; };
  EXPECT_NEAR(std::log(at(21.5) / at(22)), 0.5 / tail_mm, 0.1 / tail_mm);
  EXPECT_LT(at(18.5), 0.01 * at(20));
  double sumSharp = 0, sumBlurred = 0;
  for (std::size_t m = 0; m < sharp.size(); ++m) sumSharp += sharp[m], sumBlurred += blurred[m];
  EXPECT_NEAR(sumBlurred / sumSharp, 1, 0.02);
}

}  // namespace
}  // namespace insonate::test
