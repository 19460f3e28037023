// Compiled once for every instruction set (see foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "thesis/ThesisKernel.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target:
#include "thesis/MapRow-inl.h"
#include "thesis/ThesisKernel.h"

#include <hwy/highway.h>

#include <algorithm>
#include <chrono>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace insonate::thesis::HWY_NAMESPACE {

/// Vertices of one row of an octave's lattice, interpolated laterally to each scanline.
void noiseRow(const KernelInput& in, int firstLine, int octave, int latticeRow, KernelBuffers::NoiseRow& row) {
  const std::uint32_t seed = octaveSeed(in.noiseSeed, octave);
  const double perLine = in.thesis->noise.across * (1 << octave) / in.plan->lines;
  int column = -1;
  NoiseGradient left{}, right{};
  for (int l = 0; l < kBlockLines; ++l) {
    const double x = (firstLine + l + 0.5) * perLine;
    const auto i = static_cast<int>(x);
    if (i != column) {
      column = i;
      left = gradientAt(i, latticeRow, seed), right = gradientAt(i + 1, latticeRow, seed);
    }
    const double dx = x - i, t = fade(dx), leftValue = left.x * dx, rightValue = right.x * (dx - 1);
    row.constant[l] = static_cast<float>(leftValue + t * (rightValue - leftValue));
    row.perCell[l] = static_cast<float>(left.y + t * (right.y - left.y));
  }
}

/// Position of a gate between the rows of each octave's lattice.
struct NoiseAt {
  float dy[kNoiseOctaves], fade[kNoiseOctaves];
};

NoiseAt prepareNoise(const KernelInput& in, int firstLine, int gate, KernelBuffers& b) {
  NoiseAt at;
  const double texture = in.plan->range_mm(gate) / in.plan->settings.depth_mm;
  for (int o = 0; o < kNoiseOctaves; ++o) {
    const double y = texture * in.thesis->noise.down * (1 << o);
    const auto cell = static_cast<int>(y);
    if (cell != b.noiseCell[o]) {
      for (int r = 0; r < 2; ++r) noiseRow(in, firstLine, o, cell + r, b.noise[o][r]);
      b.noiseCell[o] = cell;
    }
    at.dy[o] = static_cast<float>(y - cell);
    at.fade[o] = static_cast<float>(fade(y - cell));
  }
  return at;
}

HWY_INLINE Vec speckleAt(const KernelBuffers& b, const NoiseAt& at, int l) {
  const Tag d;
  auto noise = hn::Zero(d);
  for (int o = 0; o < kNoiseOctaves; ++o) {
    const auto dy = hn::Set(d, at.dy[o]);
    const auto above = hn::MulAdd(hn::Load(d, b.noise[o][0].perCell + l), dy, hn::Load(d, b.noise[o][0].constant + l));
    const auto below = hn::MulAdd(hn::Load(d, b.noise[o][1].perCell + l), hn::Sub(dy, hn::Set(d, 1.0F)),
                                  hn::Load(d, b.noise[o][1].constant + l));
    const auto value = hn::MulAdd(hn::Set(d, at.fade[o]), hn::Sub(below, above), above);
    noise = hn::MulAdd(value, hn::Set(d, 1.0F / static_cast<float>(1 << o)), noise);
  }
  const float toUnit = 1 / std::sqrt(static_cast<float>(noiseVariance()));
  const auto factor = hn::MulAdd(noise, hn::Set(d, static_cast<float>(kSpeckleContrast) * toUnit), hn::Set(d, 1.0F));
  const auto rms = static_cast<float>(std::sqrt(1 + kSpeckleContrast * kSpeckleContrast));
  return hn::Mul(hn::Max(factor, hn::Zero(d)), hn::Set(d, 1 / rms));
}

void traceGate(const KernelInput& in, int firstLine, int gate, KernelBuffers& b, float* echo) {
  const Tag d;
  const FramePlan& plan = *in.plan;
  const bool speckles = plan.settings.effects.speckle && plan.settings.effects.scattering;
  const NoiseAt noise = speckles ? prepareNoise(in, firstLine, gate, b) : NoiseAt{};
  const int row = 2 * gate / plan.cellGates;
  const auto down =
      hn::Set(d, 2 * static_cast<float>(gate) / static_cast<float>(plan.cellGates) - static_cast<float>(row));
  const auto gate_mm = hn::Set(d, static_cast<float>(plan.gate_mm));
  const auto tailShare = hn::Set(d, gate == 0 ? 0.0F : static_cast<float>(in.thesis->tailShare));
  for (int l = 0; l < kBlockLines; l += static_cast<int>(hn::Lanes(d))) {
    auto scattered = hn::Zero(d), reflected = hn::Zero(d);
    for (int p = 0; p < plan.settings.elevationPlanes; ++p) {
      const KernelBuffers::MapRow &above = b.lines[p][row & 1], &below = b.lines[p][(row + 1) & 1];
      const auto between = [&](const float* top, const float* bottom) {
        const auto from = hn::Load(d, top + l);
        return hn::MulAdd(down, hn::Sub(hn::Load(d, bottom + l), from), from);
      };
      const auto loss = hn::Mul(between(above.loss_dBpmm, below.loss_dBpmm), gate_mm);
      const auto level = hn::Load(d, b.level_dB[p] + l);
      const auto middle = hn::Max(hn::NegMulAdd(loss, hn::Set(d, 0.5F), level), hn::Set(d, -300.0F));
      const auto amplitude = hn::Mul(hn::Exp(d, hn::Mul(middle, hn::Set(d, kLnPerDecibel))),
                                     hn::Set(d, static_cast<float>(plan.boundaryWeight[p])));
      hn::Store(hn::Sub(level, loss), d, b.level_dB[p] + l);
      scattered = hn::MulAdd(amplitude, between(above.echo, below.echo), scattered);
      reflected = hn::MulAdd(amplitude, between(above.reflection, below.reflection), reflected);
    }
    const auto sum =
        speckles ? hn::MulAdd(scattered, speckleAt(b, noise, l), reflected) : hn::Add(scattered, reflected);
    const auto blurred = hn::MulAdd(tailShare, hn::Sub(hn::Load(d, b.tail + l), sum), sum);
    hn::Store(blurred, d, b.tail + l);
    hn::StoreU(blurred, d, echo + l);
  }
}

/// The outermost scanlines continue beyond the image.
void extend(const FramePlan& plan, const EchoRows& echo, int firstLine) {
  for (int gate = 0; gate < plan.gates; ++gate) {
    float* first = echo.row(gate) + echo.margin;
    if (firstLine == 0) std::fill(echo.row(gate), first, first[0]);
    if (firstLine + kBlockLines >= plan.lines)
      std::fill(first + plan.lines, echo.row(gate) + echo.width, first[plan.lines - 1]);
  }
}

/// Samples the row of nodes that the map row needs first; an even map row needs the nodes behind it.
void makeMapRow(const KernelInput& in, int firstLine, int plane, int row, KernelBuffers& b) {
  const int last = in.plan->nodeRows - 1;
  const bool onNodes = row % 2 == 0;
  const int here = row / 2, next = onNodes ? here : here + 1;
  const int above = onNodes ? std::max(here - 1, 0) : here, below = onNodes ? std::min(here + 1, last) : next;
  if (onNodes && here < last) sampleRow(in, firstLine, plane, here + 1, b);
  const auto node = [&](int r) { return &b.nodes[plane][r % 3]; };
  const NodeRows rows{node(here), node(next), node(above), node(below),
                      static_cast<float>(1 / ((below - above) * in.thesis->row_mm))};
  mapRow(in, rows, in.plan->range_mm(0) + row * in.thesis->mapRow_mm(), b.columns);
  spreadRow(*in.plan, b.columns, b.lines[plane][row & 1]);
}

void traceBlockTarget(const KernelInput& in, int firstLine, KernelBuffers& b, const EchoRows& echo,
                      KernelTimes_ms& times) {
  using Clock = std::chrono::steady_clock;
  const FramePlan& plan = *in.plan;
  const int planes = plan.settings.elevationPlanes;
  for (int p = 0; p < planes; ++p) std::copy_n(in.lineLevel_dB.data() + firstLine, kBlockLines, b.level_dB[p]);
  std::fill_n(b.noiseCell, kNoiseOctaves, -1);
  std::fill_n(b.tail, kBlockLines, 0.0F);
  for (int p = 0; p < planes; ++p) {
    sampleRow(in, firstLine, p, 0, b);
    makeMapRow(in, firstLine, p, 0, b);
  }
  int gate = 0;
  for (int row = 1; row < in.thesis->mapRows; ++row) {
    const auto start = Clock::now();
    for (int p = 0; p < planes; ++p) makeMapRow(in, firstLine, p, row, b);
    const auto middle = Clock::now();
    for (; gate < plan.gates && 2 * gate < row * plan.cellGates; ++gate)
      traceGate(in, firstLine, gate, b, echo.row(gate) + echo.margin + firstLine);
    times.map += std::chrono::duration<double, std::milli>(middle - start).count();
    times.trace += std::chrono::duration<double, std::milli>(Clock::now() - middle).count();
  }
  extend(plan, echo, firstLine);
}

void blurRow(const FramePlan& plan, const std::vector<float>& lateralKernel, const EchoRows& echo, int gate,
             float* out) {
  const Tag d;
  const float* in = echo.row(gate) + echo.margin;
  const float* kernel = lateralKernel.data() + std::size_t(gate) * (plan.maxLateralRadius + 1);
  for (int l = 0; l < plan.lines; l += static_cast<int>(hn::Lanes(d))) {
    auto sum = hn::Mul(hn::Set(d, kernel[0]), hn::LoadU(d, in + l));
    for (int o = 1; o <= plan.lateralRadius[gate]; ++o)
      sum = hn::MulAdd(hn::Set(d, kernel[o]), hn::Add(hn::LoadU(d, in + l - o), hn::LoadU(d, in + l + o)), sum);
    hn::Store(sum, d, out + l);
  }
}

void blurSamplesTarget(const FramePlan& plan, const std::vector<float>& lateralKernel, const EchoRows& echo,
                       int firstSample, int endSample, float* ring, float* envelope) {
  int done = -1;  // the last gate in the ring, with the one before it
  for (int m = firstSample; m < endSample; ++m) {
    const double gate = std::clamp((m + 0.5) / plan.stride - 0.5, 0.0, plan.gates - 1.0);
    const auto before = static_cast<int>(gate);
    const int after = std::min(before + 1, plan.gates - 1);
    for (int g = std::max(done + 1, before); g <= after; ++g)
      blurRow(plan, lateralKernel, echo, g, ring + std::size_t(g & 1) * echo.width);
    done = after;
    const auto t = static_cast<float>(gate - before);
    const float *above = ring + std::size_t(before & 1) * echo.width,
                *below = ring + std::size_t(after & 1) * echo.width;
    float* out = envelope + std::size_t(m) * plan.lines;
    for (int l = 0; l < plan.lines; ++l) out[l] = above[l] + t * (below[l] - above[l]);
  }
}

}  // namespace insonate::thesis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate::thesis {
HWY_EXPORT(traceBlockTarget);
HWY_EXPORT(blurSamplesTarget);

void traceBlock(const KernelInput& input, int firstLine, KernelBuffers& buffers, const EchoRows& echo,
                KernelTimes_ms& times) {
  HWY_DYNAMIC_DISPATCH(traceBlockTarget)(input, firstLine, buffers, echo, times);
}

void blurSamples(const FramePlan& plan, const std::vector<float>& lateralKernel, const EchoRows& echo, int firstSample,
                 int endSample, float* ring, float* envelope) {
  HWY_DYNAMIC_DISPATCH(blurSamplesTarget)(plan, lateralKernel, echo, firstSample, endSample, ring, envelope);
}
}  // namespace insonate::thesis
#endif
