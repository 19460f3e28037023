// Compiled once for every instruction set (see foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/BeamKernel.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target:
#include "cpu/BeamKernel.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 16>;

void convolveAxiallyTarget(const FramePlan& plan, const BeamTables& tables, const float* blockEcho, int firstLine,
                           EchoPlane& out) {
  const Tag d;
  const int components = 2 * plan.settings.looks;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int c = 0; c < components; ++c) {
    const float* in = blockEcho + std::size_t(c) * plan.gates * kBlockLines;
    for (int gate = 0; gate < plan.gates; ++gate) {
      const float* kernel = tables.axialKernel.data() + std::size_t(gate) * (plan.maxAxialRadius + 1);
      const int radius = plan.axialRadius[gate];
      float* row = out.row(plan, c, gate) + out.margin + firstLine;
      for (int l = 0; l < kBlockLines; l += lanes) {
        auto sum = hn::Mul(hn::Set(d, kernel[0]), hn::Load(d, in + gate * kBlockLines + l));
        for (int o = 1; o <= radius; ++o) {
          const auto above = gate - o >= 0 ? hn::Load(d, in + (gate - o) * kBlockLines + l) : hn::Zero(d);
          const auto below = gate + o < plan.gates ? hn::Load(d, in + (gate + o) * kBlockLines + l) : hn::Zero(d);
          sum = hn::MulAdd(hn::Set(d, kernel[o]), hn::Add(above, below), sum);
        }
        hn::StoreU(sum, d, row + l);
      }
    }
  }
}

void lateralRow(const FramePlan& plan, const BeamTables& tables, const EchoPlane& echo, int component, int gate,
                float* out) {
  const Tag d;
  const float* in = echo.row(plan, component, gate) + echo.margin;
  const float* kernel = tables.lateralKernel.data() + std::size_t(gate) * (plan.maxLateralRadius + 1);
  const int radius = plan.lateralRadius[gate];
  for (int l = 0; l < plan.lines; l += static_cast<int>(hn::Lanes(d))) {
    auto sum = hn::Mul(hn::Set(d, kernel[0]), hn::LoadU(d, in + l));
    for (int o = 1; o <= radius; ++o)
      sum = hn::MulAdd(hn::Set(d, kernel[o]), hn::Add(hn::LoadU(d, in + l - o), hn::LoadU(d, in + l + o)), sum);
    hn::Store(sum, d, out + l);
  }
}

void convolveLaterallyTarget(const FramePlan& plan, const BeamTables& tables, const EchoPlane& echo, int firstSample,
                             int endSample, LateralBuffers& buffers, float* envelope) {
  const Tag d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int looks = plan.settings.looks;
  const auto ringRow = [&](int component, int gate) {
    return buffers.ring.get() + (std::size_t(component) * 4 + (gate & 3)) * echo.width;
  };
  int done = std::max(0, firstSample / plan.stride - 2) - 1;  // gates up to this one are in the ring
  for (int m = firstSample; m < endSample; ++m) {
    const BeamTables::Upsample& up = tables.upsample[m % plan.stride];
    const int before = m / plan.stride + up.gateBefore;
    const int need = std::min(before + 2, plan.gates - 1);
    for (; done < need; ++done)
      for (int c = 0; c < 2 * looks; ++c) lateralRow(plan, tables, echo, c, done + 1, ringRow(c, done + 1));
    int gate[4];
    for (int o = 0; o < 4; ++o) gate[o] = std::clamp(before - 1 + o, 0, plan.gates - 1);
    for (int look = 0; look < looks; ++look) {
      float* out = envelope + (std::size_t(look) * plan.grid.samples() + m) * plan.lines;
      const float *re[4], *im[4];
      for (int o = 0; o < 4; ++o) re[o] = ringRow(2 * look, gate[o]), im[o] = ringRow(2 * look + 1, gate[o]);
      for (int l = 0; l < plan.lines; l += lanes) {
        auto x = hn::Zero(d), y = hn::Zero(d);
        for (int o = 0; o < 4; ++o) {
          const auto w = hn::Set(d, up.weight[o]);
          x = hn::MulAdd(w, hn::Load(d, re[o] + l), x);
          y = hn::MulAdd(w, hn::Load(d, im[o] + l), y);
        }
        const auto magnitude = hn::Sqrt(hn::MulAdd(x, x, hn::Mul(y, y)));
        if (l + lanes <= plan.lines) {
          hn::StoreU(magnitude, d, out + l);
        } else {
          alignas(64) float tail[16];
          hn::Store(magnitude, d, tail);
          std::copy_n(tail, plan.lines - l, out + l);
        }
      }
    }
  }
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate::cpu {
HWY_EXPORT(convolveAxiallyTarget);
HWY_EXPORT(convolveLaterallyTarget);

BeamTables::BeamTables(const FramePlan& plan)
    : axialKernel(plan.axialKernel.begin(), plan.axialKernel.end()),
      lateralKernel(plan.lateralKernel.begin(), plan.lateralKernel.end()) {
  for (int m = 0; m < plan.stride; ++m) {
    const double gate = (m + 0.5) / plan.stride - 0.5;
    const int before = gate < 0 ? -1 : 0;
    const CubicWeights w = cubicAt(gate - before);
    Upsample up{before, {}};
    for (int o = 0; o < 4; ++o) up.weight[o] = static_cast<float>(w.weight[o]);
    upsample.push_back(up);
  }
}

void convolveAxially(const FramePlan& plan, const BeamTables& tables, const float* blockEcho, int firstLine,
                     EchoPlane& out) {
  HWY_DYNAMIC_DISPATCH(convolveAxiallyTarget)(plan, tables, blockEcho, firstLine, out);
}

void convolveLaterally(const FramePlan& plan, const BeamTables& tables, const EchoPlane& echo, int firstSample,
                       int endSample, LateralBuffers& buffers, float* envelope) {
  HWY_DYNAMIC_DISPATCH(convolveLaterallyTarget)(plan, tables, echo, firstSample, endSample, buffers, envelope);
}
}  // namespace insonate::cpu
#endif
