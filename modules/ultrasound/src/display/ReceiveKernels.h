#pragma once

#include <cstdint>

/// The display's inner loops before the logarithm: each processes one row of scanlines with the processor's widest
/// vector instructions. They use no fused multiply-add, so that every processor gives the same image.
namespace insonate::display {

/// Task of whiteRow(): makes one row of complex white noise, each part with unit variance. Rows of different seeds are
/// independent.
struct WhiteRow {
  std::uint32_t seed;
  int columns;
  float *real, *imaginary;
};
void whiteRow(const WhiteRow& task);

/// Electronic noise of the mean of all looks (renderings with independent speckle) in one row, of unit power. `power`
/// is the noise's power where there is no echo, `twiceInPhase` is twice its part in phase with an echo. `amplitude`
/// scales both.
struct NoiseRow {
  const float *power = nullptr, *twiceInPhase = nullptr;
  float amplitude = 0;
};

/// Task of compoundRow(): computes the power of the mean a of the looks, with noise if given: (a^2 + twiceInPhase a +
/// noise) gain^2. Invalid amplitudes count as 0. For one look this equals |a + n|^2 with complex noise n; for several
/// looks only without echo or with strong echoes.
struct CompoundRow {
  const float* look[3] = {};
  int looks;
  int columns;
  /// Share of the amplitude that each scanline keeps, by contact with the skin; null: all of it.
  const float* contact = nullptr;
  NoiseRow noise = {};  ///< electronic noise; none if its pointers are null
  float gain;
  float ceiling, strongCeiling;  ///< maximum contribution of a sample to `sum` and to `strong`
  float* power;
  float *sum, *strong;  ///< row sums for the haze: sum += min(power, ceiling), strong += min(power, strongCeiling),
                        ///< over a padded row
};
void compoundRow(const CompoundRow& task);

/// Task of ringingRow(): adds the ringing of the face to the power of a row: line[i] (touching + lack[i] (lifted -
/// touching)).
struct RingingRow {
  const float *line, *lack;
  float touching, lifted;
  int columns;
  float* power;
};
void ringingRow(const RingingRow& task);

/// Task of hazeRow(): computes the haze of one block of rows, and the tails that the block below needs, from the tails
/// of the block above.
struct HazeRow {
  const float* power;       ///< mean power of the block, strong echoes limited
  const float* strong;      ///< mean power of the block, including strong echoes
  const float* tailAbove;   ///< tail of the haze in the block above, with margins
  const float* grainAbove;  ///< local mean power (for the modulation by speckle) in the block above, with margins
  const float* longAbove;   ///< tail of strong reflectors' haze in the block above, with margins
  int stride;               ///< distance in scanlines to the neighbors to which haze spreads
  float spread;             ///< share of the haze that spreads to each neighbor
  float tailDecay, grainDecay, longDecay;
  float share, longShare, smoothShare;
  const float* smeared;  ///< haze by side lobes and second round trips, added to the tail
  const float* drift;    ///< factor on all haze, varying from place to place
  int columns;
  float *tail, *grain, *longTail, *haze;
};
void hazeRow(const HazeRow& task);

}  // namespace insonate::display
