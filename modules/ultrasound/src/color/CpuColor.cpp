#include "color/ColorPlan.h"
#include "color/ColorRegistry.h"
#include "color/FlowSegments.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ultrasound/PlaneTissue.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace insonate {
namespace {

/// Wall filter and phase by velocity, in a table over one period.
class DopplerResponse {
 public:
  explicit DopplerResponse(const ColorPlan& plan) : perVelocity_(0.5 / plan.nyquist_mmps) {
    for (int i = 0; i <= kEntries; ++i) {
      const double toward_mmps = 2 * plan.nyquist_mmps * i / kEntries;
      const double passed = plan.wallFilter(toward_mmps), phase = plan.phase(toward_mmps);
      table_[i] = {float(passed), float(passed * std::cos(phase)), float(passed * std::sin(phase))};
    }
  }
  struct Entry {
    float power, re, im;
  };
  Entry at(float toward_mmps) const {
    if (!std::isfinite(toward_mmps)) return table_[0];
    const float turns = toward_mmps * static_cast<float>(perVelocity_);
    const float place = (turns - std::floor(turns)) * kEntries;
    const int low = std::min(static_cast<int>(place), kEntries - 1);
    const float t = place - static_cast<float>(low);
    const Entry &a = table_[low], &b = table_[low + 1];
    return {a.power + t * (b.power - a.power), a.re + t * (b.re - a.re), a.im + t * (b.im - a.im)};
  }

 private:
  static constexpr int kEntries = 8192;  // the filter is steep near its cutoff
  double perVelocity_;
  std::array<Entry, kEntries + 1> table_{};
};

PlanePoint planePoint(Vec3 at_mm) {
  return {static_cast<float>(at_mm.x), static_cast<float>(at_mm.z)};
}

/// Memory for one scanline of the lattice.
struct LineWork {
  std::vector<PlanePoint> points, way;  ///< points of the gates; points of the transmission
  PlaneSamples tissue;
  std::vector<float> passed;                     ///< transmission, by its steps, then by gate
  std::vector<int> near[2];                      ///< segments near this scanline: arteries, veins
  std::vector<float> power, re, im;              ///< before the axial kernel
  std::vector<float> gatePower, gateRe, gateIm;  ///< after it, by gate of the frame
};

class CpuColor final : public ColorDoppler {
 public:
  std::string_view name() const override { return "cpu"; }
  void prepare(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color) override;
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const ColorMotion& motion, ColorFrame& frame) override;

 private:
  struct Frame {
    const AcousticScene* scene;
    Transform patientFromProbe;
    bool bloodMoves;
    Vec3 tissue_mmps;
  };
  void setPowers(const AcousticTable& table);
  void traceLine(const Frame& frame, int line);
  void transmit(const Frame& frame, int line, LineWork& work) const;
  void addPlane(const Frame& frame, int plane, Vec3 beam, LineWork& work) const;
  void selectSegments(const Frame& frame, double elevation_mm, LineWork& work) const;
  void blurAxially(LineWork& work) const;
  void blurLaterally(int line, ColorFrame& frame) const;

  std::optional<ColorPlan> plan_;
  std::optional<ShownTissue> shown_;
  std::optional<DopplerResponse> response_;
  FlowSegments segments_;
  std::array<float, 256> echoPower_{};  ///< by label, relative to the noise
  std::vector<LineWork> lines_;
};

void CpuColor::prepare(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color) {
  plan_.emplace(probe, settings, color);
  shown_.emplace(*plan_);
  response_.emplace(*plan_);
  lines_.assign(plan_->fineLines, {});
  for (LineWork& work : lines_) {
    work.points.resize(plan_->fineGates), work.way.resize(plan_->transmissionSteps);
    work.passed.resize(plan_->transmissionSteps + plan_->fineGates);
    for (auto* values : {&work.power, &work.re, &work.im}) values->resize(plan_->fineGates);
    for (auto* values : {&work.gatePower, &work.gateRe, &work.gateIm}) values->resize(plan_->gates);
    for (auto& near : work.near) near.reserve(64);
  }
}

void CpuColor::setPowers(const AcousticTable& table) {
  for (int label = 0; label < 256; ++label)
    echoPower_[label] = static_cast<float>(
        std::pow(10, table.of(static_cast<std::uint8_t>(label)).echogenicity_dB / 10) / plan_->noisePower);
}

/// As in ReferenceColor::transmissionOf(), then interpolated to the gates.
void CpuColor::transmit(const Frame& frame, int line, LineWork& work) const {
  const double beam = plan_->beam(line);
  const auto wayPoint = [](int step) { return ColorPlan::transmissionRange_mm(step); };
  shown_->restAlong(beam, plan_->transmissionSteps, wayPoint,
                    [&](int step, Vec3 rest) { work.way[step] = planePoint(rest); });
  samplePlane(*frame.scene, frame.patientFromProbe, work.way, work.tissue);
  double power = shown_->contactAbove(plan_->point_mm(beam, 0));
  power *= power;
  std::uint8_t before = kBackground;
  const AcousticTable& table = frame.scene->tissues();
  double same = 1;
  for (int step = 0; step < plan_->transmissionSteps; ++step) {
    const std::uint8_t here = work.tissue.label[step];
    if (here != kBackground) {
      if (here != before) {
        power *= transmittedPower(table, *plan_, before == kBackground ? here : before, here,
                                  ColorPlan::kTransmissionStep_mm);
        same = transmittedPower(table, *plan_, here, here, ColorPlan::kTransmissionStep_mm);
      } else {
        power *= same;
      }
      before = here;
    }
    work.passed[step] = static_cast<float>(power);
  }
  float* const byGate = work.passed.data() + plan_->transmissionSteps;
  for (int gate = 0; gate < plan_->fineGates; ++gate) {
    const double place = std::max(plan_->range_mm(gate) / ColorPlan::kTransmissionStep_mm - 0.5, 0.0);
    const int low = static_cast<int>(place);
    const float t = static_cast<float>(place - low);
    byGate[gate] = work.passed[low] + t * (work.passed[low + 1] - work.passed[low]);
  }
}

void CpuColor::selectSegments(const Frame& frame, double elevation_mm, LineWork& work) const {
  for (const int kind : {0, 1}) {
    work.near[kind].clear();
    if (!frame.bloodMoves) continue;
    const std::vector<float>& to_mm = kind == 0 ? work.tissue.toArtery_mm : work.tissue.toVein_mm;
    Vec3 low{1e30, elevation_mm, 1e30}, high{-1e30, elevation_mm, -1e30};
    for (int gate = 0; gate < plan_->fineGates; ++gate) {
      if (bloodShare(to_mm[gate]) <= 0) continue;
      const PlanePoint& p = work.points[gate];
      low.x = std::min(low.x, double(p.x_mm)), high.x = std::max(high.x, double(p.x_mm));
      low.z = std::min(low.z, double(p.z_mm)), high.z = std::max(high.z, double(p.z_mm));
    }
    if (low.x <= high.x) segments_.select(kind == 0 ? kArtery : kVein, low, high, work.near[kind]);
  }
}

/// `beam` is the direction away from the probe, probe frame.
void CpuColor::addPlane(const Frame& frame, int plane, Vec3 beam, LineWork& work) const {
  const double elevation_mm = plan_->elevation_mm[plane];
  Transform pose = frame.patientFromProbe;
  pose.offset = pose * Vec3{0, elevation_mm, 0};
  samplePlane(*frame.scene, pose, work.points, work.tissue);
  selectSegments(frame, elevation_mm, work);
  const float tissue_mmps = static_cast<float>(-dot(frame.tissue_mmps, beam));
  const DopplerResponse::Entry still = response_->at(tissue_mmps);
  const float* const passed = work.passed.data() + plan_->transmissionSteps;
  const float weight = static_cast<float>(plan_->planeWeight[plane]);
  for (int gate = 0; gate < plan_->fineGates; ++gate) {
    const auto add = [&](const DopplerResponse::Entry& echo, std::uint8_t label, float share) {
      const float power = share * weight * passed[gate] * echoPower_[label];
      work.power[gate] += power * echo.power, work.re[gate] += power * echo.re, work.im[gate] += power * echo.im;
    };
    float left = 1;
    for (const int kind : {0, 1}) {
      const float toWall_mm = (kind == 0 ? work.tissue.toArtery_mm : work.tissue.toVein_mm)[gate];
      const float share = std::min(static_cast<float>(bloodShare(toWall_mm)), left);
      if (share <= 0) continue;
      const PlanePoint& p = work.points[gate];
      const float away = segments_.along(work.near[kind], p.x_mm, static_cast<float>(elevation_mm), p.z_mm,
                                         std::max(-toWall_mm, static_cast<float>(kLeastDepth_mm)), beam);
      add(response_->at(tissue_mmps - away), kind == 0 ? kArtery : kVein, share);
      left -= share;
    }
    if (left > 0) add(still, work.tissue.label[gate], left);
  }
}

void CpuColor::blurAxially(LineWork& work) const {
  const std::vector<double>& kernel = plan_->axialKernel;
  for (int gate = 0; gate < plan_->gates; ++gate) {
    const int center = gate * ColorPlan::kFine + plan_->axialMargin;
    const auto sum = [&](const std::vector<float>& values) {
      auto total = static_cast<float>(kernel[0]) * values[center];
      for (int o = 1; o <= plan_->axialMargin; ++o)
        total += static_cast<float>(kernel[o]) * (values[center - o] + values[center + o]);
      return total;
    };
    work.gatePower[gate] = sum(work.power), work.gateRe[gate] = sum(work.re), work.gateIm[gate] = sum(work.im);
  }
}

void CpuColor::traceLine(const Frame& frame, int line) {
  LineWork& work = lines_[line];
  transmit(frame, line, work);
  const double beam = plan_->beam(line);
  const auto gateRange = [this](int gate) { return plan_->range_mm(gate); };
  shown_->restAlong(beam, plan_->fineGates, gateRange,
                    [&](int gate, Vec3 rest) { work.points[gate] = planePoint(rest); });
  for (auto* values : {&work.power, &work.re, &work.im}) std::ranges::fill(*values, 0.0F);
  for (int plane = 0; plane < ColorPlan::kPlanes; ++plane) addPlane(frame, plane, plan_->beams.direction(beam), work);
  blurAxially(work);
}

void CpuColor::blurLaterally(int line, ColorFrame& frame) const {
  const int center = line * ColorPlan::kFine + plan_->lateralMargin;
  const std::size_t first = frame.at(line, 0);
  for (auto* values : {&frame.power, &frame.lagOneRe, &frame.lagOneIm})
    std::fill_n(values->begin() + static_cast<std::ptrdiff_t>(first), plan_->gates, 0.0F);
  for (int o = -plan_->lateralMargin; o <= plan_->lateralMargin; ++o) {
    const LineWork& from = lines_[center + o];
    const double* kernel = plan_->lateralKernel.data() + std::abs(o);
    for (int gate = 0; gate < plan_->gates; ++gate) {
      const auto w = static_cast<float>(kernel[std::size_t(gate) * (plan_->lateralMargin + 1)]);
      frame.power[first + gate] += w * from.gatePower[gate];
      frame.lagOneRe[first + gate] += w * from.gateRe[gate];
      frame.lagOneIm[first + gate] += w * from.gateIm[gate];
    }
  }
}

void CpuColor::render(const AcousticScene& scene, const Transform& patientFromProbe,
                      const PlaneDisplacement& displacement, const ColorMotion& motion, ColorFrame& frame) {
  shown_->update(*plan_, scene.impl().field, patientFromProbe, displacement);
  setPowers(scene.tissues());
  const bool moves = motion.blood && !motion.blood->empty();
  if (moves) segments_.update(*motion.blood, patientFromProbe, plan_->elevation_mm.back());
  const Frame of{&scene, patientFromProbe, moves, motion.tissue_mmps};
  tbb::parallel_for(0, plan_->fineLines, [&](int line) { traceLine(of, line); });
  frame.resize(plan_->lines, plan_->gates);
  tbb::parallel_for(0, plan_->lines, [&](int line) { blurLaterally(line, frame); });
}

}  // namespace

std::unique_ptr<ColorDoppler> makeCpuColor() {
  return std::make_unique<CpuColor>();
}

}  // namespace insonate
