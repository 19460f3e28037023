#include "color/ColorPlan.h"

#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

constexpr double kLine_mm = 0.55, kGate_mm = 0.4;
/// Length of the color pulse, in cycles. Longer than that of the image, for a narrower band and less noise.
constexpr double kCycles = 4;
/// Noise in the band of the color pulse relative to that in the band of the image.
constexpr double kNarrowBand_dB = -8;
constexpr double kFwhmPerSd = 2.3548200450309493;
constexpr double kKernelReach_sd = 2.6;

ImagingSettings beamSettings(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color) {
  ImagingSettings beams = settings;
  const BeamGrid image(probe, settings);
  const double middle_mm = 0.5 * (color.near_mm + color.far_mm);
  const double width_mm = image.scanlineSpacing_mm(middle_mm) * settings.scanlines;
  beams.scanlines = std::clamp(static_cast<int>(std::lround(width_mm / kLine_mm)), 24, 256);
  beams.steering_deg = color.steering_deg;
  return beams;
}

/// Half of a Gaussian kernel with unit sum over both sides.
std::vector<double> gaussian(double sd_steps, int reach) {
  std::vector<double> half(reach + 1);
  double sum = 0;
  for (int o = 0; o <= reach; ++o) {
    half[o] = std::exp(-0.5 * o * o / (sd_steps * sd_steps));
    sum += o ? 2 * half[o] : half[o];
  }
  for (double& w : half) w /= sum;
  return half;
}

}  // namespace

ColorPlan::ColorPlan(const Probe& probe, const ImagingSettings& settings, const ColorSettings& c)
    : color(c), imaging(settings), image(probe, settings), beams(probe, beamSettings(probe, settings, c)) {
  const int all = beams.scanlines();
  firstBeam = std::clamp(static_cast<int>(std::lround(color.left * all)), 0, all - 2);
  lines = std::clamp(static_cast<int>(std::lround(color.right * all)) - firstBeam, 2, all - firstBeam);
  gates = std::max(4, static_cast<int>(std::lround((color.far_mm - color.near_mm) / kGate_mm)));
  gate_mm = (color.far_mm - color.near_mm) / gates;
  nyquist_mmps = nyquistVelocity_mmps(color);
  noisePower = std::pow(10, (settings.noise_dB + kNarrowBand_dB) / 10);
  planKernels(probe);
  fineLines = kFine * (lines - 1) + 1 + 2 * lateralMargin;
  fineGates = kFine * (gates - 1) + 1 + 2 * axialMargin;
  transmissionSteps = static_cast<int>(range_mm(fineGates - 1) / kTransmissionStep_mm) + 2;
}

/// Range below which the spacing of scanlines is taken as that at this range.
constexpr double kNearField_mm = 10;

/// Widths are those of the power, which are 1 / sqrt(2) of those of the amplitude.
void ColorPlan::planKernels(const Probe& probe) {
  ImagingSettings pulse = imaging;
  pulse.frequency_MHz = color.frequency_MHz, pulse.harmonic = false;
  const double toPowerSd = 1 / (kFwhmPerSd * std::numbers::sqrt2);
  const double fineGate_mm = gate_mm / kFine;
  const double axialSd_mm = kCycles * wavelength_mm(pulse) / 2 * toPowerSd;
  axialMargin = std::max(1, static_cast<int>(std::ceil(kKernelReach_sd * axialSd_mm / fineGate_mm)));
  axialKernel = gaussian(axialSd_mm / fineGate_mm, axialMargin);

  std::vector<double> sds(gates);
  for (int g = 0; g < gates; ++g) {
    const double range = gateRange_mm(g);
    // At the face of a phased array the scanlines nearly meet; the beam there is not wider than a few of them.
    const double spacing_mm = beams.scanlineSpacing_mm(std::max(range, kNearField_mm));
    sds[g] = lateralFwhm_mm(probe, pulse, range) * toPowerSd / (spacing_mm / kFine);
  }
  lateralMargin = std::max(1, static_cast<int>(std::ceil(kKernelReach_sd * std::ranges::max(sds))));
  for (const double sd : sds) {
    const std::vector<double> half = gaussian(sd, lateralMargin);
    lateralKernel.insert(lateralKernel.end(), half.begin(), half.end());
  }
  // Gauss-Hermite nodes of three planes.
  const double middle_mm = 0.5 * (color.near_mm + color.far_mm);
  const double sliceSd_mm = sliceLaw(probe, color.frequency_MHz).thickness_mm(middle_mm) * toPowerSd;
  elevation_mm = {-std::sqrt(3.0) * sliceSd_mm, 0, std::sqrt(3.0) * sliceSd_mm};
  planeWeight = {1.0 / 6, 2.0 / 3, 1.0 / 6};
}

double ColorPlan::phase(double toward_mmps) const {
  return std::numbers::pi * toward_mmps / nyquist_mmps;
}

double ColorPlan::wallFilter(double toward_mmps) const {
  if (color.wallFilter_Hz <= 0) return 1;
  // Sampling by pulses makes frequencies periodic.
  const double turns = toward_mmps / (2 * nyquist_mmps);
  const double ratio = std::abs(turns - std::round(turns)) * color.prf_Hz / color.wallFilter_Hz;
  return ratio > 0 ? 1 / (1 + std::pow(1 / ratio, kWallFilterPower)) : 0;
}

ShownTissue::ShownTissue(const ColorPlan& plan) : plan_(&plan) {}

void ShownTissue::update(const ColorPlan& plan, const TissueField& field, const Transform& patientFromProbe,
                         const PlaneDisplacement& displacement) {
  plan_ = &plan, displacement_ = &displacement;
  for (int column = 0; column < kColumns; ++column) {
    const double scanline = scanlineOf(plan, column);
    contacts_[column] =
        contactOf(field, patientFromProbe, displacement, plan.image.origin(scanline), plan.image.direction(scanline));
  }
  isDrawn_ = plan.imaging.conformingContact &&
             std::ranges::any_of(contacts_, [](const Contact& contact) { return contact.gap_mm != 0; });
}

Contact ShownTissue::contactAt(Vec3 shown_mm, double& range_mm, double& scanline) const {
  const BeamGrid::Location at = plan_->image.locate(shown_mm.x, shown_mm.z);
  range_mm = plan_->image.range_mm(at.sample);
  scanline = at.scanline;
  const double place = columnOf(*plan_, scanline);
  const int low = std::min(static_cast<int>(place), kColumns - 2);
  const Contact &a = contacts_[low], &b = contacts_[low + 1];
  const double t = place - low;
  return {plan_->imaging.conformingContact ? a.gap_mm + t * (b.gap_mm - a.gap_mm) : 0,
          a.strength + t * (b.strength - a.strength)};
}

Vec3 ShownTissue::restOf(Vec3 shown_mm) const {
  Vec3 drawn = shown_mm;
  if (isDrawn_) {
    double range_mm = 0, scanline = 0;
    const Contact contact = contactAt(shown_mm, range_mm, scanline);
    drawn = plan_->image.origin(scanline) + plan_->image.direction(scanline) * tissueRange_mm(range_mm, contact.gap_mm);
  }
  return displacement_->empty() ? drawn : drawn + shiftAt(*displacement_, drawn.x, drawn.z);
}

double ShownTissue::contactAbove(Vec3 shown_mm) const {
  double range_mm = 0, scanline = 0;
  return contactAt(shown_mm, range_mm, scanline).strength;
}

double transmittedPower(const AcousticTable& table, const ColorPlan& plan, std::uint8_t before, std::uint8_t here,
                        double step_mm) {
  const AcousticTissue& tissue = table.of(here);
  double passed = 1;
  if (plan.imaging.effects.attenuation) {
    const double loss_dB =
        2 * tissue.attenuation_dBpcmMHz * step_mm / 10 * std::pow(plan.color.frequency_MHz, tissue.attenuationExponent);
    passed = std::pow(10, -loss_dB / 10);
  }
  if (before == here || !plan.imaging.effects.transmission) return passed;
  const double z1 = table.of(before).impedance_MRayl, z2 = tissue.impedance_MRayl;
  const double reflected = (z2 - z1) / (z2 + z1), amplitude = 1 - reflected * reflected;
  return passed * amplitude * amplitude;
}

}  // namespace insonate
