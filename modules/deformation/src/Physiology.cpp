#include <insonate/core/Range.h>
#include <insonate/deformation/Physiology.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

namespace insonate {
namespace {

using std::numbers::pi;

constexpr double kKilopascalPermmHg = kPascalPermmHg / 1000;
constexpr double kBlood_kgPerm3 = 1060, kGravity_mPers2 = 9.81;

/// Share of inspiration in a breath: one part to one and a half.
constexpr double kBreathingIn = 0.4;

/// Largest distance of a site below the heart that still lies above the diaphragm.
constexpr double kDiaphragm_mm = 100;
/// Pressure in the abdomen below which the pressure in the veins of the legs does not fall, since the inferior vena
/// cava is then compressed; and change of these veins by respiration relative to the change in the neck.
constexpr double kAbdomen_mmHg = 2, kAbdominalShare = 0.4;

/// Hydrostatic pressure of blood over `length_mm` along the body, with the head end lowered by the tilt.
double hydrostatic_mmHg(double length_mm, double tilt_deg) {
  return kBlood_kgPerm3 * kGravity_mPers2 * length_mm / 1000 * std::sin(tilt_deg * pi / 180) / kPascalPermmHg;
}

double phaseOf(double time_s, double rate_perMin) {
  const double turns = std::isfinite(time_s) ? time_s * rate_perMin / 60 : 0;
  return turns - std::floor(turns);
}

/// Pulse of the carotid pressure from 0 (diastolic) to 1 (systolic) with mean 1/3, so that mean pressure is diastolic
/// and a third of the pulse: a quick rise, an exponential fall, and the dicrotic wave after the valve has closed.
double pulse(double phase) {
  constexpr double kRise = 0.15, kFall = 2.7640727;  // the second makes the mean 1/3
  constexpr double kDicrotic = 0.42, kDicroticHalf = 0.08, kDicroticHeight = 0.1;
  if (phase < kRise) return (1 - std::cos(pi * phase / kRise)) / 2;
  const double end = std::exp(-kFall);
  const double fall = (std::exp(-kFall * (phase - kRise) / (1 - kRise)) - end) / (1 - end);
  const double away = std::abs(phase - kDicrotic) / kDicroticHalf;
  return fall + (away < 1 ? kDicroticHeight * (1 + std::cos(pi * away)) / 2 : 0);
}

/// Respiration from 1/2 (end of expiration) to -1/2 (end of inspiration) and back, with mean 0.
double breath(double phase) {
  const double half = phase < kBreathingIn ? phase / kBreathingIn : 1 + (phase - kBreathingIn) / (1 - kBreathingIn);
  return std::cos(pi * half) / 2;
}

double artery_mmHg(const Physiology& p, double pulseNow) {
  return p.diastolic_mmHg + (p.systolic_mmHg - p.diastolic_mmHg) * pulseNow +
         hydrostatic_mmHg(p.siteAboveHeart_mm, p.tilt_deg);
}

double openVein_mmHg(const Physiology& p, double breathNow) {
  const double hydrostatic = hydrostatic_mmHg(p.siteAboveHeart_mm + p.indifferenceFromHeart_mm, p.tilt_deg);
  if (p.siteAboveHeart_mm >= -kDiaphragm_mm)
    return p.centralVenous_mmHg + p.breathingSwing_mmHg * breathNow + hydrostatic;
  return std::max(p.centralVenous_mmHg + hydrostatic, kAbdomen_mmHg) -
         kAbdominalShare * std::abs(p.breathingSwing_mmHg) * breathNow;
}

double vein_mmHg(const Physiology& p, double breathNow) {
  return std::max(openVein_mmHg(p, breathNow), 0.0);
}

Result<void> checkPhysiologicalRange(double value, double low, double high, const char* field) {
  return checkRange(value, low, high, std::string("Physiology: ") + field);
}

Result<void> checkRate(double value, double low, double high, const char* field) {
  if (value == 0) return {};
  auto ok = checkPhysiologicalRange(value, low, high, field);
  if (!ok) ok.error().message.insert(ok.error().message.size() - 1, ", or 0 for none");
  return ok;
}

}  // namespace

Result<void> checkPhysiology(const Physiology& p) {
  return checkPhysiologicalRange(p.centralVenous_mmHg, -5, 30, "centralVenous_mmHg")
      .and_then([&] { return checkPhysiologicalRange(p.systolic_mmHg, 40, 260, "systolic_mmHg"); })
      .and_then([&] { return checkPhysiologicalRange(p.diastolic_mmHg, 20, 180, "diastolic_mmHg"); })
      .and_then([&]() -> Result<void> {
        if (p.systolic_mmHg > p.diastolic_mmHg) return {};
        std::ostringstream text;
        text << "Physiology: systolic_mmHg is " << p.systolic_mmHg << ", which must be above diastolic_mmHg, "
             << p.diastolic_mmHg << ".";
        return fail(text.str());
      })
      .and_then([&] { return checkRate(p.heartRate_perMin, 20, 250, "heartRate_perMin"); })
      .and_then([&] { return checkRate(p.breathing_perMin, 2, 60, "breathing_perMin"); })
      .and_then([&] { return checkPhysiologicalRange(p.breathingSwing_mmHg, -20, 20, "breathingSwing_mmHg"); })
      .and_then([&] { return checkPhysiologicalRange(p.tilt_deg, -45, 45, "tilt_deg"); })
      .and_then([&] { return checkPhysiologicalRange(p.siteAboveHeart_mm, -600, 300, "siteAboveHeart_mm"); })
      .and_then([&] { return checkPhysiologicalRange(p.indifferenceFromHeart_mm, 0, 200, "indifferenceFromHeart_mm"); })
      .and_then([&] { return checkPhysiologicalRange(p.lungSlide_mm, 0, 30, "lungSlide_mm"); });
}

double heartPhaseAt(const Physiology& p, double time_s) {
  return phaseOf(time_s, p.heartRate_perMin);
}

double respirationAt(const Physiology& p, double time_s) {
  return p.breathing_perMin > 0 ? breath(phaseOf(time_s, p.breathing_perMin)) : 0;
}

double lungSlideAt_mm(const Physiology& p, double time_s) {
  return p.lungSlide_mm * respirationAt(p, time_s);
}

BloodPressure bloodPressureAt(const Physiology& p, double time_s) {
  const double pulseNow = p.heartRate_perMin > 0 ? pulse(heartPhaseAt(p, time_s)) : 1.0 / 3;
  return {artery_mmHg(p, pulseNow) * kKilopascalPermmHg, vein_mmHg(p, respirationAt(p, time_s)) * kKilopascalPermmHg};
}

double venousPressure_mmHg(const Physiology& p, double time_s) {
  return openVein_mmHg(p, p.breathing_perMin > 0 ? breath(phaseOf(time_s, p.breathing_perMin)) : 0);
}

BloodPressure meanBloodPressure(const Physiology& p) {
  // If the vein collapses during a part of the breath, its mean differs from that of an open vein.
  constexpr int kSteps = 1000;
  double vein = 0;
  for (int i = 0; i < kSteps; ++i)
    vein += vein_mmHg(p, p.breathing_perMin > 0 ? breath((i + 0.5) / kSteps) : 0) / kSteps;
  return {artery_mmHg(p, 1.0 / 3) * kKilopascalPermmHg, vein * kKilopascalPermmHg};
}

}  // namespace insonate
