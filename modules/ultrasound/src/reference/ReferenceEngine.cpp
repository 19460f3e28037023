#include "reference/ReferenceEngine.h"

#include "model/Boundary.h"
#include "model/Contact.h"
#include "model/FramePlan.h"
#include "model/Impulse.h"
#include "model/NeedleEchoes.h"
#include "model/PointEchoes.h"
#include "model/Reverberation.h"
#include "model/Scatterers.h"
#include "reference/TissueLookup.h"
#include "scene/SceneData.h"
#include "thesis/ThesisReference.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <optional>
#include <span>
#include <utility>

namespace insonate {
namespace {

using Complex = std::complex<double>;

constexpr double kNothing = 1e-9;

double fromDecibel(double dB) {
  return std::pow(10.0, dB / 20);
}

/// [look][gate][line]
class EchoField {
 public:
  EchoField(int looks, int gates, int lines)
      : gates_(gates), lines_(lines), values_(std::size_t(looks) * gates * lines) {}
  Complex& at(int look, int gate, int line) { return values_[(std::size_t(look) * gates_ + gate) * lines_ + line]; }
  const Complex& at(int look, int gate, int line) const {
    return values_[(std::size_t(look) * gates_ + gate) * lines_ + line];
  }

 private:
  int gates_, lines_;
  std::vector<Complex> values_;
};

/// Remaining amplitude of the beam along every scanline of every elevation plane, and its mean over the aperture's
/// rays.
class BeamLevels {
 public:
  explicit BeamLevels(const FramePlan& plan)
      : plan_(plan),
        inside_(std::size_t(plan.settings.elevationPlanes) * plan.gates * plan.lines),
        behind_(std::size_t(plan.gates + 1) * plan.lines),
        seen_(std::size_t(plan.gates) * plan.lines) {}

  /// Amplitude, there and back, in the middle of a gate of a scanline by itself; 0 where the tissue is unknown.
  double& inside(int plane, int gate, int line) {
    return inside_[(std::size_t(plane) * plan_.gates + gate) * plan_.lines + line];
  }
  double inside(int plane, int gate, int line) const {
    return const_cast<BeamLevels*>(this)->inside(plane, gate, line);
  }
  /// Mean of the planes before a gate.
  double& reaching(int gate, int line) { return behind_[std::size_t(gate) * plan_.lines + line]; }
  double reaching(int gate, int line) const {
    return std::max(behind_[std::size_t(gate) * plan_.lines + line], ApertureRays::kFaintest);
  }
  /// The same mean over the rays of the aperture.
  double seen(int gate, int line) const { return seen_[std::size_t(gate) * plan_.lines + line]; }

  void followRays() {
    for (int ray = 0; ray < ApertureRays::kCount; ++ray) followRay(ray);
    for (double& seen : seen_)
      if (seen < ApertureRays::kUnseen) seen = 0;
  }

 private:
  void followRay(int ray) {
    const int last = plan_.lines - 1;
    std::vector<double> here(plan_.lines), left(plan_.lines);
    for (int l = 0; l <= last; ++l) here[l] = reaching(0, l);
    for (int gate = 0; gate < plan_.gates; ++gate) {
      for (int l = 0; l <= last; ++l) {
        seen_[std::size_t(gate) * plan_.lines + l] += ApertureRays::kWeight[ray] * here[l];
        left[l] = here[l] * std::as_const(*this).reaching(gate + 1, l) / std::as_const(*this).reaching(gate, l);
      }
      if (gate + 1 == plan_.gates) break;
      const double shift = plan_.aperture.shift_lines(ray, gate + 1);
      for (int l = 0; l <= last; ++l)
        here[l] = left[l] + std::abs(shift) * (left[std::clamp(l + (shift > 0 ? 1 : -1), 0, last)] - left[l]);
    }
  }

  const FramePlan& plan_;
  std::vector<double> inside_, behind_, seen_;
};

/// Echoes of one scanline, before the beam's point-spread function.
class LineTracer {
 public:
  LineTracer(const FramePlan& plan, const AcousticScene::Impl& scene, const TissueLookup& lookup,
             const ScattererLattice& lattice, const NeedleEchoes& needle, BeamLevels& levels, EchoField& echo)
      : plan_(plan), scene_(scene), lookup_(lookup), lattice_(lattice), needle_(needle), levels_(levels), echo_(echo) {}

  /// Boundaries of one elevation plane, and the remaining amplitude.
  void descend(int plane, int line) {
    const Effects& effects = plan_.settings.effects;
    const double f_MHz = plan_.settings.frequency_MHz, weight = plan_.boundaryWeight[plane];
    double amplitude = std::max(lookup_.contact(line).strength, kNothing);  // there and back, before this gate
    levels_.reaching(0, line) += weight * amplitude;
    std::optional<TissueSample> previous;
    for (int gate = 0; gate < plan_.gates; ++gate) {
      const TissueSample here = lookup_.at(plane, gate, line);
      if (!here.inside) return;  // no tissue is known outside the volume
      const double lit = fromDecibel(-needle_.shadow_dB(plane, line, gate));
      if (previous && previous->label != here.label)
        amplitude *= boundary(plane, gate, line, *previous, here, amplitude * lit);

      const AcousticTissue& tissue = scene_.table.of(here.label);
      double loss_dB = 2 * tissue.attenuation_dBpcmMHz * std::pow(f_MHz, tissue.attenuationExponent);
      if (here.grazesVessel && effects.edgeShadow) loss_dB += 2 * acoustics::kEdgeLoss_dBpcmMHz * f_MHz;
      if (!effects.attenuation || here.outside) loss_dB = 0;
      loss_dB *= plan_.gate_mm / 10;
      const double left = std::max(amplitude, ApertureRays::kFaintest);
      levels_.inside(plane, gate, line) = left * fromDecibel(-loss_dB / 2);
      amplitude *= fromDecibel(-loss_dB);
      levels_.reaching(gate + 1, line) += weight * std::max(left * fromDecibel(-loss_dB), ApertureRays::kFaintest);
      previous = here;
    }
  }

  /// Scattering of one elevation plane, with the amplitude that reaches it from the aperture.
  void scatter(int plane, int line) {
    for (int gate = 0; gate < plan_.gates; ++gate) {
      const double left = levels_.inside(plane, gate, line);
      if (left == 0) return;
      const TissueSample here = lookup_.at(plane, gate, line);
      const double lit = fromDecibel(-needle_.shadow_dB(plane, line, gate));
      const double share = left / std::as_const(levels_).reaching(gate, line);
      if (!here.outside) scatter(plane, gate, line, here, lit * share * levels_.seen(gate, line));
    }
  }

  void addNeedle(int line) {
    const int central = plan_.settings.elevationPlanes / 2;
    const auto level_dB = [&](int gate) {
      return static_cast<float>(20 * std::log10(std::max(levels_.inside(central, gate, line), kNothing)));
    };
    needle_.addTo(line, level_dB, [&](int gate, float amplitude) {
      for (int look = 0; look < plan_.settings.looks; ++look) echo_.at(look, gate, line) += amplitude;
    });
  }

 private:
  /// Echo of the boundary between two gates; returns the share of amplitude that passes, there and back.
  double boundary(int plane, int gate, int line, const TissueSample& above, const TissueSample& below,
                  double amplitude) {
    if (above.outside) return 1;  // gel
    const double z1 = above.impedance_MRayl, z2 = below.impedance_MRayl;
    const double reflection = (z2 - z1) / (z2 + z1);
    if (plan_.settings.effects.reflection && amplitude > ApertureRays::kUnseen) {
      const AcousticTissue &first = scene_.table.of(above.label), &second = scene_.table.of(below.label);
      const AcousticTissue& surface = surfaceOf(first, second);
      const bool rough = plan_.settings.effects.texture;
      const double roughness_dB = rough ? roughnessGain_dB(surface, below.patch) : 0;
      const double echo = amplitude * std::abs(reflection) * fromDecibel(acoustics::kReflectorGain_dB + roughness_dB) *
                          specularLobe(first, second, below.cosine);
      const double fraction =
          above.cell == below.cell || above.pair == below.pair ? above.s_mm / (above.s_mm - below.s_mm) : 0.5;
      const double spread_mm = std::hypot(below.spread_mm, rough ? roughnessDepth_mm(surface) : 0);
      const Impulse impulse(gate - 1 + fraction, spread_mm / plan_.gate_mm);
      for (int o = 0; o < impulse.count; ++o)
        for (int look = 0; look < plan_.settings.looks; ++look)
          if (const int g = impulse.first + o; g >= 0 && g < plan_.gates)
            echo_.at(look, g, line) += impulse.weight[o] * echo * plan_.boundaryScale * plan_.boundaryWeight[plane];
    }
    return plan_.settings.effects.transmission ? 1 - reflection * reflection : 1;
  }

  void scatter(int plane, int gate, int line, const TissueSample& here, double amplitude) {
    const double echo = amplitude * fromDecibel(here.echo_dB);
    // Echoes in phase have the same level after the beam, whatever its width.
    const double inPhase = plan_.settings.effects.speckle ? here.sheet : 1;
    const double loose = echo * plan_.scatterScale[gate] * plan_.scatterWeight[plane];
    const auto n = scattererAmplitudes(lattice_, here.patient_mm);
    for (int look = 0; look < plan_.settings.looks; ++look) {
      echo_.at(look, gate, line) += echo * inPhase * plan_.boundaryWeight[plane];
      if (plan_.settings.effects.speckle) echo_.at(look, gate, line) += loose * Complex(n[2 * look], n[2 * look + 1]);
    }
  }

  const FramePlan& plan_;
  const AcousticScene::Impl& scene_;
  const TissueLookup& lookup_;
  const ScattererLattice& lattice_;
  const NeedleEchoes& needle_;
  BeamLevels& levels_;
  EchoField& echo_;
};

void reverberate(const Reverberation& behindGas, std::span<const float> strength, int looks, int line, int gasGate,
                 int gates, EchoField& echo) {
  for (int look = 0; look < looks; ++look) {
    std::vector<Complex> above(gasGate + 1);
    for (int g = 0; g <= gasGate; ++g) above[g] = echo.at(look, g, line);
    for (int g = gasGate + Reverberation::kFirstGate; g < gates; ++g)
      for (const Reverberation::Repeat& r : behindGas.at(g - gasGate))
        if (r.gatesAbove <= gasGate)
          echo.at(look, g, line) += double(r.share) * strength[r.strength] * above[gasGate - r.gatesAbove];
  }
}

EchoField convolveAxially(const FramePlan& plan, const EchoField& in) {
  EchoField out(plan.settings.looks, plan.gates, plan.lines);
  for (int look = 0; look < plan.settings.looks; ++look)
    for (int g = 0; g < plan.gates; ++g) {
      const int radius = plan.axialRadius[g];
      const double* kernel = plan.axialKernel.data() + std::size_t(g) * (plan.maxAxialRadius + 1);
      for (int o = std::max(-radius, -g); o <= std::min(radius, plan.gates - 1 - g); ++o)
        for (int l = 0; l < plan.lines; ++l) out.at(look, g, l) += kernel[std::abs(o)] * in.at(look, g + o, l);
    }
  return out;
}

EchoField convolveLaterally(const FramePlan& plan, const EchoField& in) {
  EchoField out(plan.settings.looks, plan.gates, plan.lines);
  for (int look = 0; look < plan.settings.looks; ++look)
    for (int g = 0; g < plan.gates; ++g) {
      const int radius = plan.lateralRadius[g];
      const double* kernel = plan.lateralKernel.data() + std::size_t(g) * (plan.maxLateralRadius + 1);
      for (int l = 0; l < plan.lines; ++l)
        for (int o = std::max(-radius, -l); o <= std::min(radius, plan.lines - 1 - l); ++o)
          out.at(look, g, l) += kernel[std::abs(o)] * in.at(look, g, l + o);
    }
  return out;
}

/// Magnitude on every sample.
void envelopeOf(const FramePlan& plan, const EchoField& echo, EnvelopeFrame& envelope) {
  envelope.resize(plan.lines, plan.grid.samples(), plan.settings.looks);
  for (int look = 0; look < plan.settings.looks; ++look)
    for (int m = 0; m < plan.grid.samples(); ++m) {
      const double gate = (m + 0.5) / plan.stride - 0.5;
      const int g0 = static_cast<int>(std::floor(gate));
      const CubicWeights w = cubicAt(gate - g0);
      for (int l = 0; l < plan.lines; ++l) {
        Complex sum;
        for (int o = 0; o < 4; ++o) sum += w.weight[o] * echo.at(look, std::clamp(g0 - 1 + o, 0, plan.gates - 1), l);
        envelope.look(look)[std::size_t(m) * plan.lines + l] = static_cast<float>(std::abs(sum));
      }
    }
}

class ReferenceEngine final : public Engine {
 public:
  std::string_view name() const override { return "reference"; }

  void prepare(const Probe& probe, const ImagingSettings& settings) override {
    needle_.emplace(plan_.emplace(probe, settings));
  }

  void render(const AcousticScene& sceneHandle, const Transform& patientFromProbe,
              const PlaneDisplacement& displacement, const Instruments& instruments, EnvelopeFrame& envelope) override {
    const auto start = std::chrono::steady_clock::now();
    needle_->place(instruments, sceneHandle.impl().field, patientFromProbe, displacement);
    if (plan_->settings.look == Look::Thesis)
      thesis::renderReference(*plan_, sceneHandle.impl(), patientFromProbe, displacement, envelope);
    else
      renderCoherent(sceneHandle.impl(), patientFromProbe, displacement, envelope);
    const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    stages_ = {{"frame", time.count()}};
  }

  const std::vector<Stage>& stages() const override { return stages_; }

 private:
  void renderCoherent(const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                      const PlaneDisplacement& displacement, EnvelopeFrame& envelope) {
    const FramePlan& plan = *plan_;
    const TissueLookup lookup(plan, scene, patientFromProbe, displacement);
    const ScattererLattice lattice(patientFromProbe.linear.column[1], plan.latticePitch_mm,
                                   plan.latticeElevationPitch_mm, plan.specklePattern);
    EchoField echo(plan.settings.looks, plan.gates, plan.lines);
    const Reverberation behindGas(plan);
    std::vector<float> strength(behindGas.strengths());
    BeamLevels levels(plan);
    LineTracer tracer(plan, scene, lookup, lattice, *needle_, levels, echo);
    const int planes = plan.settings.elevationPlanes;
    for (int line = 0; line < plan.lines; ++line)
      for (int plane = 0; plane < planes; ++plane) tracer.descend(plane, line);
    levels.followRays();
    for (int line = 0; line < plan.lines; ++line) {
      for (int plane = 0; plane < planes && plan.settings.effects.scattering; ++plane) tracer.scatter(plane, line);
      if (const int gas = lookup.firstGasGate(line); gas > 0 && plan.settings.effects.reverberation) {
        behindGas.strengthsAt(lookup.at(planes / 2, gas, line).patient_mm, scene, displacement.lung, strength);
        reverberate(behindGas, strength, plan.settings.looks, line, gas, plan.gates, echo);
      }
      tracer.addNeedle(line);
    }
    for (const PointEcho& point : pointEchoes(plan, scene.points, patientFromProbe, displacement))
      for (int look = 0; look < plan.settings.looks; ++look) echo.at(look, point.gate, point.line) += point.amplitude;
    envelopeOf(plan, convolveLaterally(plan, convolveAxially(plan, echo)), envelope);
  }

  std::optional<FramePlan> plan_;
  std::optional<NeedleEchoes> needle_;
  std::vector<Stage> stages_;
};

}  // namespace

std::unique_ptr<Engine> makeReferenceEngine() {
  return std::make_unique<ReferenceEngine>();
}

}  // namespace insonate
