#pragma once

#include <cstdint>

/// The display's inner loops from the logarithm on: one row of scanlines each, with the widest instructions that the
/// processor has. They use no fused multiply-add, so that every processor gives the same image.
namespace insonate::display {

/// Level in dB of power plus haze, offset and shade.
struct CompressRow {
  const float *power, *hazeBefore, *hazeAfter;
  const float *meanBefore, *meanAfter;  ///< mean power of the blocks that the haze was found for
  float hazeGrain;                      ///< share of the haze that has the grain of `power`
  float mix;
  float offset_dB, low_dB, high_dB;
  const float* shade_dB;  ///< of each scanline
  float shadeShare;       ///< of it that this row has
  const float* line_dB;   ///< of each scanline, in all rows; may be null
  int columns;
  float* level_dB;
  float* sum;  ///< += level
};
void compressRow(const CompressRow& task);

void scaleRow(float* row, float factor, int columns);

/// Local mean: (1 2 1) over blocks, (1 2 3 2 1) over strided scanlines.
void meanRow(const float* above, const float* here, const float* below, int stride, int columns, float* mean);

/// Products of the differences across (x) and along (z) the scanlines.
struct TensorRow {
  const float *above, *here, *below;
  int stride;
  float lateral, axial;
  int columns;
  float *xx, *xz, *zz;
};
void tensorRow(const TensorRow& task);

/// From the tensor averaged over neighbors: how much structure there is (0..1), how much of it is an interface that
/// can be followed (0..1, less than the former), and that interface's slope, in the
/// first of each 8 scanlines.
struct OrientRow {
  const float *xx[5] = {}, *xz[5] = {}, *zz[5] = {};  ///< two blocks above to two below
  int stride;
  float from, to, maxSlope;
  int columns;
  float *structure, *edge, *slope;
};
void orientRow(const OrientRow& task);

/// Smooths one row of levels: in all directions where there is only speckle, along the interface where there is one,
/// and along the scanline where there is structure too steep to follow.
struct SmoothRow {
  const float* axial[5] = {};  ///< rows of the axial taps, with margins
  float axialWeight[3] = {};
  int plainStride = 1;
  float plainWeight[3] = {};
  const float* origin;  ///< row 0 of the levels
  int rowStride, rows, row;
  int alongStride = 1;
  float alongWeight[4] = {};
  const float* slope;  ///< rows per along-tap and unit of slope are in `rowsPerSlope`
  float rowsPerSlope;
  const float *structureBefore, *structureAfter, *edgeBefore, *edgeAfter, *meanBefore, *meanAfter;
  float mix;
  float contrast, contrastBend, contrastReach;
  float strength;  ///< share of the smoothed levels in what is written
  int margin, columns;
  float* out;
};
void smoothRow(const SmoothRow& task);

/// Raises a level by a share of its difference from the levels above and below, at most by that of `reach_dB`.
struct EnhanceRow {
  const float *above, *here, *below;
  float share, reach_dB;
  int columns;
  float* level_dB;
};
void enhanceRow(const EnhanceRow& task);

/// Levels to gray, after mixing with the previous image where `previous` is given (it receives the mixture).
struct GreyRow {
  const float* level_dB;
  float* previous;
  float persistence;
  float black_dB, perLevel;
  float a, b, c;
  int columns;
  std::uint8_t* grey;
};
void greyRow(const GreyRow& task);

/// Each column, as the low byte, with the place halfway to the next, as the high byte: the cubic through four columns,
/// (-1 9 9 -1) / 16. Reads one column before the first and two past the last; reads and writes whole vectors.
void refineRow(const std::uint8_t* grey, int columns, std::uint16_t* fine);

/// Packs each sample with its right, lower and lower right neighbor, lowest byte first.
void packRow(const std::uint8_t* here, const std::uint8_t* below, int columns, std::uint32_t* packed);

/// Bilinear interpolation between the four neighbors in packed[index]; weights are x and z in 1/256, low byte x.
/// Writes `count` pixels; index and weight are readable up to the next multiple of 16.
void scanRow(const std::uint32_t* packed, const std::int32_t* index, const std::uint16_t* weight, int count,
             std::uint8_t* grey);

}  // namespace insonate::display
