#include "color/ColorPlan.h"
#include "color/ColorRegistry.h"
#include "scene/FieldSampling.h"

#include <insonate/tissue/Labels.h>

#include <cmath>
#include <complex>
#include <optional>

namespace insonate {
namespace {

struct Autocorrelation {
  double power = 0;
  std::complex<double> lagOne;

  void add(const Autocorrelation& other, double weight) {
    power += weight * other.power;
    lagOne += weight * other.lagOne;
  }
};

double distanceTo(const TissueField& field, Vec3 patient_mm, std::uint8_t label) {
  for (int c = 0; c < field.channels; ++c)
    if (field.label[c] == label) return sampleDistance(field, c, field.nodeFromPatient * patient_mm);
  return TissueField::kReach_mm;
}

std::uint8_t nearestLabel(const TissueField& field, Vec3 patient_mm) {
  int nearest = 0;
  double least = 1e30;
  for (int c = 0; c < field.channels; ++c)
    if (const double d = sampleDistance(field, c, field.nodeFromPatient * patient_mm); d < least)
      least = d, nearest = c;
  return field.label[nearest];
}

class ReferenceColor final : public ColorDoppler {
 public:
  std::string_view name() const override { return "reference"; }
  void prepare(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color) override {
    plan_.emplace(probe, settings, color);
    shown_.emplace(*plan_);
  }
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const ColorMotion& motion, ColorFrame& frame) override;

 private:
  Autocorrelation echoAt(Vec3 patient_mm, Vec3 beam) const;
  Autocorrelation echoes(std::uint8_t label, double toward_mmps) const;
  std::vector<double> transmissionOf(int fineLine) const;
  void traceLattice();
  Autocorrelation sampleVolume(int line, int gate) const;

  std::optional<ColorPlan> plan_;
  std::optional<ShownTissue> shown_;
  const AcousticScene::Impl* scene_ = nullptr;
  Transform patientFromProbe_;
  ColorMotion motion_;
  std::vector<Autocorrelation> lattice_;  ///< [line][gate] of the fine lattice, sum of the elevation planes
};

/// Echoes of a tissue whose scatterers move with this velocity, after the wall filter.
Autocorrelation ReferenceColor::echoes(std::uint8_t label, double toward_mmps) const {
  const double power =
      std::pow(10, scene_->table.of(label).echogenicity_dB / 10) * plan_->wallFilter(toward_mmps) / plan_->noisePower;
  return {power, std::polar(power, plan_->phase(toward_mmps))};
}

/// `beam` is the direction away from the probe, patient LPS.
Autocorrelation ReferenceColor::echoAt(Vec3 patient_mm, Vec3 beam) const {
  const TissueField& field = scene_->field;
  const double tissue_mmps = -dot(patientFromProbe_.linear * motion_.tissue_mmps, beam);
  Autocorrelation sum;
  double left = 1;
  for (const std::uint8_t vessel : {kArtery, kVein}) {
    const double toWall_mm = distanceTo(field, patient_mm, vessel), share = std::min(bloodShare(toWall_mm), left);
    if (share <= 0) continue;
    const double depth_mm = std::max(-toWall_mm, kLeastDepth_mm);
    const Vec3 blood = motion_.blood ? bloodVelocity_mmps(*motion_.blood, vessel, patient_mm, depth_mm) : Vec3{};
    sum.add(echoes(vessel, tissue_mmps - dot(blood, beam)), share);
    left -= share;
  }
  if (left > 0) sum.add(echoes(nearestLabel(field, patient_mm), tissue_mmps), left);
  return sum;
}

/// Share of the power that returns from each step of a scanline.
std::vector<double> ReferenceColor::transmissionOf(int fineLine) const {
  const double beam = plan_->beam(fineLine);
  std::vector<double> passed;
  double power = shown_->contactAbove(plan_->point_mm(beam, 0));
  power *= power;
  std::uint8_t before = kBackground;
  const auto wayPoint = [](int step) { return ColorPlan::transmissionRange_mm(step); };
  shown_->restAlong(beam, plan_->transmissionSteps, wayPoint, [&](int, Vec3 rest) {
    const std::uint8_t here = nearestLabel(scene_->field, patientFromProbe_ * rest);
    // In front of the skin there is gel, which does not weaken the echoes.
    if (here != kBackground)
      power *= transmittedPower(scene_->table, *plan_, before == kBackground ? here : before, here,
                                ColorPlan::kTransmissionStep_mm);
    if (here != kBackground) before = here;
    passed.push_back(power);
  });
  return passed;
}

void ReferenceColor::traceLattice() {
  lattice_.assign(std::size_t(plan_->fineLines) * plan_->fineGates, {});
  for (int line = 0; line < plan_->fineLines; ++line) {
    const std::vector<double> passed = transmissionOf(line);
    const Vec3 beam = patientFromProbe_.linear * plan_->beams.direction(plan_->beam(line));
    const auto gateRange = [this](int gate) { return plan_->range_mm(gate); };
    shown_->restAlong(plan_->beam(line), plan_->fineGates, gateRange, [&](int gate, Vec3 rest) {
      const double range_mm = std::max(plan_->range_mm(gate), 0.0);
      const double step = std::max(range_mm / ColorPlan::kTransmissionStep_mm - 0.5, 0.0);
      const int low = static_cast<int>(step);
      const double through = passed[low] + (step - low) * (passed[low + 1] - passed[low]);
      Autocorrelation& sum = lattice_[std::size_t(line) * plan_->fineGates + gate];
      for (int plane = 0; plane < ColorPlan::kPlanes; ++plane)
        sum.add(echoAt(patientFromProbe_ * (rest + Vec3{0, plan_->elevation_mm[plane], 0}), beam),
                plan_->planeWeight[plane] * through);
    });
  }
}

Autocorrelation ReferenceColor::sampleVolume(int line, int gate) const {
  Autocorrelation sum;
  const int centerLine = line * ColorPlan::kFine + plan_->lateralMargin;
  const int centerGate = gate * ColorPlan::kFine + plan_->axialMargin;
  for (int l = -plan_->lateralMargin; l <= plan_->lateralMargin; ++l) {
    const double across = plan_->lateralKernel[std::size_t(gate) * (plan_->lateralMargin + 1) + std::abs(l)];
    for (int g = -plan_->axialMargin; g <= plan_->axialMargin; ++g)
      sum.add(lattice_[std::size_t(centerLine + l) * plan_->fineGates + centerGate + g],
              across * plan_->axialKernel[std::abs(g)]);
  }
  return sum;
}

void ReferenceColor::render(const AcousticScene& scene, const Transform& patientFromProbe,
                            const PlaneDisplacement& displacement, const ColorMotion& motion, ColorFrame& frame) {
  scene_ = &scene.impl(), patientFromProbe_ = patientFromProbe, motion_ = motion;
  shown_->update(*plan_, scene_->field, patientFromProbe, displacement);
  traceLattice();
  frame.resize(plan_->lines, plan_->gates);
  for (int line = 0; line < plan_->lines; ++line)
    for (int gate = 0; gate < plan_->gates; ++gate) {
      const Autocorrelation sum = sampleVolume(line, gate);
      const std::size_t at = frame.at(line, gate);
      frame.power[at] = static_cast<float>(sum.power);
      frame.lagOneRe[at] = static_cast<float>(sum.lagOne.real());
      frame.lagOneIm[at] = static_cast<float>(sum.lagOne.imag());
    }
}

}  // namespace

std::unique_ptr<ColorDoppler> makeReferenceColor() {
  return std::make_unique<ReferenceColor>();
}

}  // namespace insonate
