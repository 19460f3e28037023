#pragma once

#include "scene/TissueField.h"

#include <algorithm>
#include <cmath>

namespace insonate {

/// The eight nodes of the tissue field around a continuous node index, and their interpolation weights; outside the
/// field, nodes at the edge are repeated.
struct FieldCell {
  std::size_t offset[8];
  double weight[8];
  bool inside;  ///< true if the index lies at most half a node outside the field
};

inline FieldCell cellAt(const TissueField& field, Vec3 node) {
  FieldCell cell;
  cell.inside = true;
  int low[3], high[3];
  double f[3];
  for (int a = 0; a < 3; ++a) {
    const double last = field.size[a] - 1;
    cell.inside = cell.inside && node[a] >= -0.5 && node[a] <= last + 0.5;
    const double at = std::clamp(node[a], 0.0, last);
    low[a] = std::min(static_cast<int>(at), std::max(field.size[a] - 2, 0));
    high[a] = std::min(low[a] + 1, field.size[a] - 1);
    f[a] = at - low[a];
  }
  for (int c = 0; c < 8; ++c) {
    cell.offset[c] = field.offset(c & 1 ? high[0] : low[0], c & 2 ? high[1] : low[1], c & 4 ? high[2] : low[2]);
    cell.weight[c] = (c & 1 ? f[0] : 1 - f[0]) * (c & 2 ? f[1] : 1 - f[1]) * (c & 4 ? f[2] : 1 - f[2]);
  }
  return cell;
}

/// Returns the signed distance to one channel's structure at a continuous node index, mm.
inline double sampleDistance(const TissueField& field, int channel, Vec3 node) {
  const FieldCell cell = cellAt(field, node);
  double d = 0;
  for (int c = 0; c < 8; ++c) d += cell.weight[c] * field.distance[cell.offset[c]].to[channel];
  return d / TissueField::kUnitsPerMm;
}

}  // namespace insonate
