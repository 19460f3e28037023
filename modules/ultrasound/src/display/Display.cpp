#include "DisplayPlan.h"
#include "ElectronicNoise.h"
#include "FaceEchoes.h"
#include "Haze.h"
#include "InterfaceSmoothing.h"
#include "Plane.h"
#include "ReceiveKernels.h"
#include "RowKernels.h"
#include "ScanConverter.h"

#include <insonate/ultrasound/Display.h>
#include <insonate/ultrasound/GrayMaps.h>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

namespace insonate {

using namespace display;

namespace {

constexpr int kBlocksPerTask = 8;
using Range = tbb::blocked_range<int>;

double powerOf(double level_dB) {
  return std::pow(10, level_dB / 10);
}

}  // namespace

struct Display::Impl {
  Impl(const Probe& probe, const ImagingSettings& imaging);

  void process(const EnvelopeFrame& envelope, std::uint32_t noiseSeed);
  void findShade();
  void compoundBlock(const EnvelopeFrame& envelope, int looks, int block);
  bool fits(const EnvelopeFrame& envelope) const;
  void compressBlock(int block);
  void finishRow(int row);
  template <class Body>
  void overBlocks(const Body& body) const;

  ImagingSettings settings;
  DisplayPlan plan;
  Plane power, levels;
  Plane blockPower, strongPower, blockLevels;
  Haze haze;
  Plane shade;  ///< one row: dB of each scanline
  std::optional<ElectronicNoise> noise;
  std::optional<FaceEchoes> face;
  std::optional<InterfaceSmoothing> smoothing;
  std::optional<Plane> previous;  ///< levels of the last image, if persistence is on
  bool hasPrevious = false;
  const GrayMapCurve& curve;
  ScanConverter scan;
  Stages_ms stages;
};

Display::Impl::Impl(const Probe& probe, const ImagingSettings& imaging)
    : settings(imaging),
      plan(probe, imaging),
      power(plan.samples, plan.scanlines),
      levels(plan.samples, plan.scanlines),
      blockPower(static_cast<int>(plan.blocks.size()), plan.scanlines),
      strongPower(blockPower.rows(), plan.scanlines),
      blockLevels(blockPower.rows(), plan.scanlines),
      haze(probe, imaging, plan),
      shade(1, plan.scanlines),
      curve(curveOf(imaging.grayMap)),
      scan(probe, imaging) {
  if (imaging.effects.noise && imaging.noise_dB > kNoNoise_dB) noise.emplace(probe, imaging, plan);
  if (imaging.effects.nearField) face.emplace(probe, imaging, plan);
  if (imaging.speckleReduction > 0) smoothing.emplace(plan, imaging.speckleReduction);
  if (imaging.persistence > 0) previous.emplace(plan.samples, plan.scanlines);
}

template <class Body>
void Display::Impl::overBlocks(const Body& body) const {
  tbb::parallel_for(Range(0, blockPower.rows(), kBlocksPerTask), [&](const Range& range) {
    for (int b = range.begin(); b < range.end(); ++b) body(b);
  });
}

bool Display::Impl::fits(const EnvelopeFrame& envelope) const {
  return envelope.scanlines == plan.scanlines && envelope.samples == plan.samples && envelope.looks >= 1 &&
         envelope.looks <= settings.looks &&
         envelope.amplitude.size() == std::size_t(plan.scanlines) * plan.samples * envelope.looks;
}

void Display::Impl::compoundBlock(const EnvelopeFrame& envelope, int looks, int b) {
  const Block& block = plan.blocks[b];
  std::fill_n(blockPower.row(b), Plane::padded(plan.scanlines), 0.0F);
  std::fill_n(strongPower.row(b), Plane::padded(plan.scanlines), 0.0F);
  for (int k = block.first; k < block.first + block.count; ++k) {
    CompoundRow task{.looks = looks,
                     .columns = plan.scanlines,
                     .contact = face ? face->contact(b) : nullptr,
                     .gain = plan.rowGain[k],
                     .ceiling = static_cast<float>(powerOf(kHazeCeiling_dB)),
                     .strongCeiling = b < plan.longHazeFrom ? 0 : static_cast<float>(powerOf(kHazeLongCeiling_dB)),
                     .power = power.row(k),
                     .sum = blockPower.row(b),
                     .strong = strongPower.row(b)};
    for (int l = 0; l < looks; ++l) task.look[l] = envelope.look(l) + std::size_t(k) * plan.scanlines;
    if (noise && looks > 0) task.noise = noise->row(k);
    compoundRow(task);
    if (face && looks > 0) face->addTo(power.row(k), k, plan.rowGain[k]);
  }
  for (Plane* mean : {&blockPower, &strongPower})
    scaleRow(mean->row(b), 1 / static_cast<float>(block.count), plan.scanlines);
}

/// Streaks below bright places near the skin: difference of the top of each scanline from its neighborhood.
void Display::Impl::findShade() {
  float* const out = shade.row(0);
  std::copy(plan.edgeShade_dB.begin(), plan.edgeShade_dB.end(), out);
  const int lines = plan.scanlines;
  std::array<float, 1025> before{};  // running sum, for means over any range of scanlines
  for (int l = 0; l < lines; ++l) {
    float sum = 0;
    for (int b = plan.shadeFirst; b < plan.shadeEnd; ++b) sum += blockPower.row(b)[l];
    before[l + 1] = before[l] + sum;
  }
  const auto mean = [&](int l, int reach) {
    const int first = std::max(l - reach, 0), end = std::min(l + reach + 1, lines);
    return std::max((before[end] - before[first]) / static_cast<float>(end - first), 1e-6F);
  };
  constexpr auto kReach = static_cast<float>(kStreakReach_dB);
  for (int l = 0; l < lines; ++l) {
    const float above_dB = 10 * std::log10(mean(l, plan.streakNarrow) / mean(l, plan.streakWide));
    out[l] -= static_cast<float>(kStreakShare) * std::clamp(above_dB, -kReach, kReach);
  }
}

void Display::Impl::compressBlock(int b) {
  const Block& block = plan.blocks[b];
  std::fill_n(blockLevels.row(b), Plane::padded(plan.scanlines), 0.0F);
  for (int k = block.first; k < block.first + block.count; ++k) {
    const auto [before, after, mix] = plan.between(k);
    compressRow({.power = power.row(k),
                 .hazeBefore = haze.row(before),
                 .hazeAfter = haze.row(after),
                 .meanBefore = blockPower.row(before),
                 .meanAfter = blockPower.row(after),
                 .hazeGrain = static_cast<float>(kHazeGrain),
                 .mix = mix,
                 .offset_dB = plan.rowOffset_dB[k],
                 .low_dB = plan.low_dB,
                 .high_dB = plan.high_dB,
                 .shade_dB = shade.row(0),
                 .shadeShare = plan.shadeShare[k],
                 .line_dB = plan.line_dB.empty() ? nullptr : plan.line_dB.data(),
                 .columns = plan.scanlines,
                 .level_dB = levels.row(k),
                 .sum = blockLevels.row(b)});
    levels.extendRow(k);
  }
  scaleRow(blockLevels.row(b), 1 / static_cast<float>(block.count), plan.scanlines);
  blockLevels.extendRow(b);
}

void Display::Impl::finishRow(int k) {
  alignas(64) std::array<float, 1024> finished;
  const float* row = levels.row(k);
  if (smoothing) {
    smoothing->smooth(plan, levels, k, finished.data());
    row = finished.data();
  }
  if (settings.edgeEnhancement > 0) {
    if (!smoothing) std::copy_n(row, Plane::padded(plan.scanlines), finished.data());
    enhanceRow({.above = levels.row(k - plan.edgeRows),
                .here = levels.row(k),
                .below = levels.row(k + plan.edgeRows),
                .share = static_cast<float>(kEdgeShare * settings.edgeEnhancement),
                .reach_dB = static_cast<float>(kEdgeReach_dB),
                .columns = plan.scanlines,
                .level_dB = finished.data()});
    row = finished.data();
  }
  const bool mixes = previous && hasPrevious;
  if (previous && !hasPrevious) std::copy_n(row, Plane::padded(plan.scanlines), previous->row(k));
  greyRow({.level_dB = row,
           .previous = mixes ? previous->row(k) : nullptr,
           .persistence = static_cast<float>(settings.persistence),
           .black_dB = plan.black_dB,
           .perLevel = plan.perLevel,
           .a = curve.a,
           .b = curve.b,
           .c = curve.c,
           .columns = plan.scanlines,
           .gray = scan.greyRow(k)});
}

void Display::Impl::process(const EnvelopeFrame& envelope, std::uint32_t noiseSeed) {
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  const auto lap_ms = [&last] {
    const auto now = Clock::now();
    return std::chrono::duration<double, std::milli>(now - std::exchange(last, now)).count();
  };
  const int looks = fits(envelope) ? envelope.looks : 0;
  if (noise && looks > 0) noise->draw(noiseSeed);
  overBlocks([&](int b) { compoundBlock(envelope, looks, b); });
  if (settings.effects.clutter) haze.follow(blockPower, strongPower, face ? &*face : nullptr);
  if (settings.effects.attenuation) findShade();
  stages.compound = lap_ms();
  overBlocks([&](int b) { compressBlock(b); });
  stages.compress = lap_ms();
  if (smoothing) smoothing->analyse(blockLevels);
  overBlocks([&](int b) {
    const Block& block = plan.blocks[b];
    for (int k = block.first; k < block.first + block.count; ++k) finishRow(k);
  });
  hasPrevious = previous.has_value();
  stages.smooth = lap_ms();
}

Display::Display(const Probe& probe, const ImagingSettings& settings)
    : impl_(std::make_unique<Impl>(probe, settings)) {}
Display::~Display() = default;
Display::Display(Display&&) noexcept = default;
Display& Display::operator=(Display&&) noexcept = default;

void Display::process(const EnvelopeFrame& envelope, BModeImage& image, std::uint32_t noiseSeed) {
  impl_->process(envelope, noiseSeed);
  const auto start = std::chrono::steady_clock::now();
  impl_->scan.convert(image);
  impl_->stages.scanConvert =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

void Display::reset() {
  impl_->hasPrevious = false;
}

const Display::Stages_ms& Display::stages() const {
  return impl_->stages;
}

}  // namespace insonate
