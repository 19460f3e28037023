#include "DisplayPlan.h"
#include "InterfaceSmoothing.h"
#include "Plane.h"
#include "RowKernels.h"
#include "ScanConverter.h"

#include <insonate/ultrasound/Display.h>

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

  void process(const EnvelopeFrame& envelope);
  void addHaze();
  void compoundBlock(const EnvelopeFrame& envelope, int looks, int block);
  bool fits(const EnvelopeFrame& envelope) const;
  void compressBlock(int block);
  void finishRow(int row);
  template <class Body>
  void overBlocks(const Body& body) const;

  ImagingSettings settings;
  DisplayPlan plan;
  Plane power, levels;
  Plane blockPower, blockLevels, tail, grain, haze;
  std::optional<InterfaceSmoothing> smoothing;
  std::optional<Plane> previous;  ///< levels of the last picture, with persistence
  bool hasPrevious = false;
  GreyCurve curve;
  ScanConverter scan;
  Stages_ms stages;
};

Display::Impl::Impl(const Probe& probe, const ImagingSettings& imaging)
    : settings(imaging),
      plan(probe, imaging),
      power(plan.samples, plan.scanlines),
      levels(plan.samples, plan.scanlines),
      blockPower(static_cast<int>(plan.blocks.size()), plan.scanlines),
      blockLevels(blockPower.rows(), plan.scanlines),
      tail(blockPower.rows(), plan.scanlines),
      grain(blockPower.rows(), plan.scanlines),
      haze(blockPower.rows(), plan.scanlines),
      curve(greyCurve(imaging.greyMap)),
      scan(probe, imaging) {
  if (imaging.smoothing) smoothing.emplace(plan);
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
         envelope.looks <= 3 &&
         envelope.amplitude.size() == std::size_t(plan.scanlines) * plan.samples * envelope.looks;
}

void Display::Impl::compoundBlock(const EnvelopeFrame& envelope, int looks, int b) {
  const Block& block = plan.blocks[b];
  std::fill_n(blockPower.row(b), Plane::padded(plan.scanlines), 0.0F);
  for (int k = block.first; k < block.first + block.count; ++k) {
    CompoundRow task{.looks = looks,
                     .columns = plan.scanlines,
                     .gain = plan.rowGain[k],
                     .ceiling = static_cast<float>(powerOf(kHazeCeiling_dB)),
                     .power = power.row(k),
                     .sum = blockPower.row(b)};
    for (int l = 0; l < looks; ++l) task.look[l] = envelope.look(l) + std::size_t(k) * plan.scanlines;
    compoundRow(task);
  }
  scaleRow(blockPower.row(b), 1 / static_cast<float>(block.count), plan.scanlines);
}

void Display::Impl::addHaze() {
  for (int b = 0; b < haze.rows(); ++b) {
    hazeRow({.power = blockPower.row(b),
             .tailAbove = b == 0 ? blockPower.row(0) : tail.row(b - 1),
             .grainAbove = b == 0 ? blockPower.row(0) : grain.row(b - 1),
             .spread = plan.blocks[b].hazeSpread,
             .tailDecay = plan.hazeDecay,
             .grainDecay = plan.hazeGrainDecay,
             .share = static_cast<float>(powerOf(kHazeShare_dB)),
             .smoothShare = static_cast<float>(kHazeSmoothShare),
             .columns = plan.scanlines,
             .tail = tail.row(b),
             .grain = grain.row(b),
             .haze = haze.row(b)});
    tail.extendRow(b);
    grain.extendRow(b);
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
                 .mix = mix,
                 .offset_dB = plan.rowOffset_dB[k],
                 .low_dB = plan.low_dB,
                 .high_dB = plan.high_dB,
                 .columns = plan.scanlines,
                 .level_dB = levels.row(k),
                 .sum = blockLevels.row(b)});
    levels.extendRow(k);
  }
  scaleRow(blockLevels.row(b), 1 / static_cast<float>(block.count), plan.scanlines);
  blockLevels.extendRow(b);
}

void Display::Impl::finishRow(int k) {
  alignas(64) std::array<float, 1024> smoothed;
  const float* row = levels.row(k);
  if (smoothing) {
    smoothing->smooth(plan, levels, k, smoothed.data());
    row = smoothed.data();
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
           .grey = scan.greyRow(k)});
}

void Display::Impl::process(const EnvelopeFrame& envelope) {
  using Clock = std::chrono::steady_clock;
  auto last = Clock::now();
  const auto lap_ms = [&last] {
    const auto now = Clock::now();
    return std::chrono::duration<double, std::milli>(now - std::exchange(last, now)).count();
  };
  const int looks = fits(envelope) ? envelope.looks : 0;
  overBlocks([&](int b) { compoundBlock(envelope, looks, b); });
  if (settings.effects.clutter) {
    blockPower.extendRow(0);
    addHaze();
  }
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

void Display::process(const EnvelopeFrame& envelope, BModeImage& image) {
  impl_->process(envelope);
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
