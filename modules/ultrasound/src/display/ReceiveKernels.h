#pragma once

#include <cstdint>

/// The display's inner loops before the logarithm: each processes one row of scanlines with the processor's widest
/// vector instructions. They use no fused multiply-add, so that every processor gives the same image.
namespace insonate::display {

/// One row of white noise: complex, each part with unit variance. Rows of different seeds are independent.
struct WhiteRow {
  std::uint32_t seed;
  int columns;
  float *real, *imaginary;
};
void whiteRow(const WhiteRow& task);

/// Noise of the mean of the looks in one row, of unit power. `power` is the noise's power where there is no echo,
/// `twiceInPhase` is twice its part in phase with an echo. `amplitude` scales both.
struct NoiseRow {
  const float *power = nullptr, *twiceInPhase = nullptr;
  float amplitude = 0;
};

/// Computes the power of the mean of the looks, with noise if given: (a^2 + twiceInPhase a + noise) gain^2. Invalid
/// amplitudes count as 0. For one look this equals |a + n|^2 with complex noise n. For several looks it equals this
/// only without echo or with strong echoes.
struct CompoundRow {
  const float* look[3] = {};
  int looks;
  int columns;
  const float* contact = nullptr;  ///< share of the amplitude that a scanline keeps; null: all of it
  NoiseRow noise = {};             ///< no noise if its pointers are null
  float gain;
  float ceiling, strongCeiling;  ///< limits of each sample's contribution to the sums
  float* power;
  float *sum, *strong;  ///< += min(power, ceiling), += min(power, strongCeiling) over a padded row
};
void compoundRow(const CompoundRow& task);

/// Adds the face's own echoes to the power of a row: line[i] (touching + lack[i] (lifted - touching)).
struct RingingRow {
  const float *line, *lack;
  float touching, lifted;
  int columns;
  float* power;
};
void ringingRow(const RingingRow& task);

/// One block of the haze: reads the tails of the block above, and computes this block's tails and haze.
struct HazeRow {
  const float* power;       ///< mean of the block, strong echoes limited
  const float* strong;      ///< mean of the block, including strong echoes
  const float* tailAbove;   ///< has margins
  const float* grainAbove;  ///< has margins
  const float* longAbove;   ///< has margins
  int stride;               ///< distance in scanlines to the neighbors
  float spread;             ///< share that spreads to each neighbor
  float tailDecay, grainDecay, longDecay;
  float share, longShare, smoothShare;
  const float* smeared;  ///< added to the tail
  const float* drift;    ///< strength of tail and smeared echoes
  int columns;
  float *tail, *grain, *longTail, *haze;
};
void hazeRow(const HazeRow& task);

}  // namespace insonate::display
