#pragma once

#include <span>

namespace insonate {

/// Filters rows with a symmetric kernel: out[i] = weight[0] in[0][i] + sum over o > 0 of weight[o] (in[-o][i] +
/// in[+o][i]), for i in 0 .. out.size(). `rows` holds the 2 R + 1 rows in[-R] .. in[R], `weight` R + 1 values; `out`
/// may not overlap them.
void weighRows(std::span<const float* const> rows, std::span<const float> weight, std::span<float> out);

/// Computes the minimum over the rows: out[i] = min of rows[r][i] + add[r] over all r.
void leastOfRows(std::span<const float* const> rows, std::span<const float> add, std::span<float> out);

/// Sets least[i] to values[i] if values[i] is above zero and smaller than least[i].
void leastPositive(std::span<const float> values, std::span<float> least);

/// Converts squared distances to signed ones: out[i] = half - sqrt(inside2[i]) if outside2[i] is 0, else
/// sqrt(outside2[i]) - half.
void signedDistance(std::span<const float> outside2, std::span<const float> inside2, float half, std::span<float> out);

}  // namespace insonate
