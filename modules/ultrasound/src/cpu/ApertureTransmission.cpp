// Compiled once for every instruction set (see foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/ApertureTransmission.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target:
#include "cpu/ApertureTransmission.h"

#include <hwy/highway.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 16>;

/// Carries the amplitude that passes a gate to the next one, moved by up to a scanline. Beyond the sides, the outermost
/// value continues.
void moveRayTarget(const float* above, const float* passed, float shift_lines, int lines, float* below) {
  const Tag d;
  constexpr int kWidest = 1024 + 2 * 16;
  HWY_ALIGN float left[kWidest];
  float* const behind = left + 16;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int l = 0; l < lines; l += lanes)
    hn::StoreU(hn::Mul(hn::LoadU(d, above + l), hn::LoadU(d, passed + l)), d, behind + l);
  behind[-1] = behind[0], behind[lines] = behind[lines - 1];
  const int side = shift_lines > 0 ? 1 : -1;
  const auto share = hn::Set(d, std::abs(shift_lines));
  for (int l = 0; l < lines; l += lanes) {
    const auto here = hn::LoadU(d, behind + l), beside = hn::LoadU(d, behind + l + side);
    hn::StoreU(hn::MulAdd(share, hn::Sub(beside, here), here), d, below + l);
  }
}

/// Scattering and boundaries of a block at one gate, all components; `nextComponent` floats apart.
void lightGateTarget(const float* const* ray, int components, std::size_t nextComponent, const float* boundaries,
                     float* echo) {
  const Tag d;
  for (int l = 0; l < kBlockLines; l += static_cast<int>(hn::Lanes(d))) {
    auto mean = hn::Zero(d);
    for (int r = 0; r < ApertureRays::kCount; ++r)
      mean = hn::MulAdd(hn::Set(d, static_cast<float>(ApertureRays::kWeight[r])), hn::LoadU(d, ray[r] + l), mean);
    const auto seen = hn::Ge(mean, hn::Set(d, static_cast<float>(ApertureRays::kUnseen)));
    const auto lit = hn::IfThenElseZero(seen, mean), inPhase = hn::Load(d, boundaries + l);
    for (int c = 0; c < components; ++c) {
      float* const at = echo + std::size_t(c) * nextComponent + l;
      hn::Store(hn::MulAdd(hn::Load(d, at), lit, c % 2 == 0 ? inPhase : hn::Zero(d)), d, at);
    }
  }
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate::cpu {
HWY_EXPORT(moveRayTarget);
HWY_EXPORT(lightGateTarget);

ApertureTransmission::ApertureTransmission(const FramePlan& plan)
    : plan_(&plan),
      width_((plan.lines + kBlockLines - 1) / kBlockLines * kBlockLines + 2 * kMargin),
      lines_(plan.lines) {
  const std::size_t size = std::size_t(plan.gates) * width_;
  const auto zeros = [](std::size_t count) {
    AlignedArray<float> values = hwy::AllocateAligned<float>(count);
    std::fill_n(values.get(), count, 0.0F);
    return values;
  };
  contact_ = zeros(width_), passed_ = zeros(size);
  for (auto& values : ray_) values = zeros(size);
}

void ApertureTransmission::followRays() {
  tbb::parallel_for(0, ApertureRays::kCount, [this](int ray) { followRay(ray); });
}

void ApertureTransmission::followRay(int ray) {
  float* const values = ray_[ray].get();
  std::copy_n(contact_.get(), width_, values);
  for (int gate = 0; gate + 1 < plan_->gates; ++gate) HWY_DYNAMIC_DISPATCH(moveRayTarget)
  (values + at(gate), passed_.get() + at(gate), static_cast<float>(plan_->aperture.shift_lines(ray, gate + 1)), lines_,
   values + at(gate + 1));
}

void ApertureTransmission::light(int firstLine, BlockEchoes& echoes) const {
  const std::size_t nextComponent = std::size_t(plan_->gates) * kBlockLines;
  for (int gate = 0; gate < plan_->gates; ++gate) {
    const float* rays[ApertureRays::kCount];
    for (int r = 0; r < ApertureRays::kCount; ++r) rays[r] = ray_[r].get() + at(gate) + firstLine;
    const std::size_t row = std::size_t(gate) * kBlockLines;
    HWY_DYNAMIC_DISPATCH(lightGateTarget)
    (rays, 2 * plan_->settings.looks, nextComponent, echoes.boundaries.get() + row, echoes.echo.get() + row);
  }
}
}  // namespace insonate::cpu
#endif
