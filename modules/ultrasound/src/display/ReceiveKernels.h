#pragma once

#include <cstdint>

/// The display's inner loops before the logarithm: one row of scanlines each, with the widest instructions that the
/// processor has. They use no fused multiply-add, so that every processor gives the same image.
namespace insonate::display {

/// One row of white noise: complex, each part with unit variance. Rows of different seeds are independent.
struct WhiteRow {
  std::uint32_t seed;
  int columns;
  float *real, *imaginary;
};
void whiteRow(const WhiteRow& task);

/// Noise of the looks' mean in one row, of unit power: its power where there is no echo, and twice its part in phase
/// with an echo; and the amplitude to which both are brought.
struct NoiseRow {
  const float *power = nullptr, *twiceInPhase = nullptr;
  float amplitude = 0;
};

/// Power of the looks' mean, unusable amplitudes as 0, with noise where there is some: (a^2 + twiceInPhase a + noise)
/// gain^2. For one look this is |a + n|^2 with complex noise n; for more it is so where there is no echo and where the
/// echo is strong.
struct CompoundRow {
  const float* look[3] = {};
  int looks;
  int columns;
  const float* contact = nullptr;  ///< share of the amplitude that a scanline keeps; null for all of it
  NoiseRow noise = {};             ///< none where null
  float gain;
  float ceiling, strongCeiling;  ///< of each sample's part in the sums
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

/// One block of the haze: the tails carried down from the block above, and the haze that they leave here.
struct HazeRow {
  const float* power;       ///< mean of the block
  const float* strong;      ///< mean of the block, strong echoes included
  const float* tailAbove;   ///< with margins
  const float* grainAbove;  ///< with margins
  const float* longAbove;   ///< with margins
  int stride;               ///< scanlines to the neighbors
  float spread;             ///< to each neighbor
  float tailDecay, grainDecay, longDecay;
  float share, longShare, smoothShare;
  const float* smeared;  ///< added to the tail
  const float* drift;    ///< strength of both
  int columns;
  float *tail, *grain, *longTail, *haze;
};
void hazeRow(const HazeRow& task);

}  // namespace insonate::display
