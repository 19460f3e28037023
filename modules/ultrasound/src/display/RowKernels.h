#pragma once

#include <cstdint>

/// The display's inner loops from the logarithm on: each processes one row of scanlines with the processor's widest
/// vector instructions. They use no fused multiply-add, so that every processor gives the same image.
namespace insonate::display {

/// Task of compressRow(): computes for one row the level in dB of power plus haze, and adds gain offsets and streak
/// losses.
struct CompressRow {
  const float *power, *hazeBefore, *hazeAfter;
  const float *meanBefore, *meanAfter;  ///< mean power of the blocks from which the haze was computed
  float hazeGrain;                      ///< share of the haze that is modulated by the speckle of `power`
  float mix;
  float offset_dB, low_dB, high_dB;
  const float* shade_dB;  ///< [scanline] loss of streaks below bright places and of the array's ends
  float shadeShare;       ///< share of shade_dB that applies to this row
  const float* line_dB;   ///< lateral gain of each scanline, the same for all rows; may be null
  int columns;
  float* level_dB;
  float* sum;  ///< adds each level to this row of sums
};
void compressRow(const CompressRow& task);

void scaleRow(float* row, float factor, int columns);

/// Computes a local mean with the weights (1 2 1) over three blocks of rows and (1 2 3 2 1) over scanlines `stride`
/// apart.
void meanRow(const float* above, const float* here, const float* below, int stride, int columns, float* mean);

/// Task of tensorRow(): computes the products xx, xz, zz of the level differences between scanlines (x) and along them
/// (z).
struct TensorRow {
  const float *above, *here, *below;
  int stride;
  float lateral, axial;
  int columns;
  float *xx, *xz, *zz;
};
void tensorRow(const TensorRow& task);

/// Task of orientRow(): computes from the structure tensor, averaged over neighbors, the strength of structure (0 to
/// 1), the strength of an interface that can be followed (0 to 1, not more than that of structure), and the interface's
/// slope, which is set for the first of every 8 scanlines.
struct OrientRow {
  /// Rows of the tensor's components, from two blocks above to two below.
  const float *xx[5] = {}, *xz[5] = {}, *zz[5] = {};
  int stride;
  float from, to, maxSlope;
  int columns;
  float *structure, *edge, *slope;
};
void orientRow(const OrientRow& task);

/// Task of smoothRow(): smooths one row of levels: plain speckle in all directions, an interface along itself, and
/// structure that is too steep to follow along the scanline.
struct SmoothRow {
  const float* axial[5] = {};  ///< rows of levels at the 5 axial taps, with margins
  float axialWeight[3] = {};
  int plainStride = 1;
  float plainWeight[3] = {};
  const float* origin;  ///< pointer to row 0 of the levels
  int rowStride, rows, row;
  int alongStride = 1;
  float alongWeight[4] = {};
  const float* slope;  ///< slope of the interface; `rowsPerSlope` converts it to rows per tap along the interface
  float rowsPerSlope;
  const float *structureBefore, *structureAfter, *edgeBefore, *edgeAfter, *meanBefore, *meanAfter;
  float mix;
  float contrast, contrastBend, contrastReach;
  float strength;  ///< weight of the smoothed levels in the output, 0 to 1
  int margin, columns;
  float* out;
};
void smoothRow(const SmoothRow& task);

/// Task of enhanceRow(): adds to each level a share of its difference from the levels above and below; the difference
/// is limited to `reach_dB`.
struct EnhanceRow {
  const float *above, *here, *below;
  float share, reach_dB;
  int columns;
  float* level_dB;
};
void enhanceRow(const EnhanceRow& task);

/// Task of greyRow(): converts a row of levels to gray. If `previous` is given, the levels are first mixed with the
/// previous image, and the mixture is stored in `previous`.
struct GreyRow {
  const float* level_dB;
  float* previous;
  float persistence;
  float black_dB, perLevel;
  float a, b, c;
  int columns;
  std::uint8_t* gray;
};
void greyRow(const GreyRow& task);

/// Doubles the columns of a gray row: writes for each column its value as the low byte, and the value halfway to the
/// next column as the high byte, interpolated by the cubic through four columns, (-1 9 9 -1) / 16. Reads one column
/// before the first and two after the last; reads and writes whole vectors.
void refineRow(const std::uint8_t* gray, int columns, std::uint16_t* fine);

/// Packs each gray value with its right, lower and lower right neighbors into 32 bits, lowest byte first.
void packRow(const std::uint8_t* here, const std::uint8_t* below, int columns, std::uint32_t* packed);

/// Interpolates bilinearly between the four neighbors in packed[index]; the weights are x and z in 1/256, with x in the
/// low byte. Writes `count` pixels; index and weight are readable up to the next multiple of 16.
void scanRow(const std::uint32_t* packed, const std::int32_t* index, const std::uint16_t* weight, int count,
             std::uint8_t* gray);

}  // namespace insonate::display
