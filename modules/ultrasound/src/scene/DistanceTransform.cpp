#include "scene/DistanceTransform.h"

#include "scene/RowFilters.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {
namespace {

constexpr float kReach = static_cast<float>(TissueField::kReach_mm);
constexpr float kFar2 = kReach * kReach;

struct Lattice {
  std::array<int, 3> size;
  std::array<std::size_t, 3> step;
  Vec3 spacing_mm;
};

/// Runs `row(begin)` for every lattice line of the x direction.
template <class Row>
void forRows(const Lattice& g, const Row& row) {
  tbb::parallel_for(0, g.size[2], [&](int k) {
    for (int j = 0; j < g.size[1]; ++j) row(j, k, k * g.step[2] + j * g.step[1]);
  });
}

/// Squared distance along x to the nearest node of the structure.
void distanceAlongX(const Lattice& g, const std::vector<std::uint8_t>& nodeLabel, std::uint8_t label,
                    std::vector<float>& d2) {
  const auto h = static_cast<float>(g.spacing_mm.x);
  forRows(g, [&](int, int, std::size_t row) {
    float run = kReach;
    for (int i = 0; i < g.size[0]; ++i) {
      run = nodeLabel[row + i] == label ? 0 : std::min(run + h, kReach);
      d2[row + i] = run;
    }
    run = kReach;
    for (int i = g.size[0] - 1; i >= 0; --i) {
      run = nodeLabel[row + i] == label ? 0 : std::min(run + h, kReach);
      d2[row + i] = std::min(d2[row + i], run) * std::min(d2[row + i], run);
    }
  });
}

/// Lower envelope of parabolas along one further axis, by brute force within the reach: the window is a few nodes wide,
/// and vectors run along x.
void distanceAlong(const Lattice& g, int axis, const std::vector<float>& in, std::vector<float>& out) {
  const double h = g.spacing_mm[axis];
  const int window = static_cast<int>(kReach / h);
  forRows(g, [&](int j, int k, std::size_t row) {
    const int here = axis == 1 ? j : k;
    thread_local std::vector<const float*> rows;
    thread_local std::vector<float> add;
    rows.clear(), add.clear();
    for (int o = std::max(-window, -here); o <= std::min(window, g.size[axis] - 1 - here); ++o) {
      rows.push_back(in.data() + row + std::ptrdiff_t(o) * std::ptrdiff_t(g.step[axis]));
      add.push_back(static_cast<float>(o * h * o * h));
    }
    leastOfRows(rows, add, {out.data() + row, std::size_t(g.size[0])});
  });
}

/// Half of a Gaussian of unit sum, centre first.
std::vector<float> gaussian(double sd_nodes) {
  const int radius = static_cast<int>(std::ceil(3 * sd_nodes));
  std::vector<float> weight;
  double sum = 0;
  for (int o = -radius; o <= radius; ++o) sum += std::exp(-0.5 * o * o / (sd_nodes * sd_nodes));
  for (int o = 0; o <= radius; ++o)
    weight.push_back(static_cast<float>(std::exp(-0.5 * o * o / (sd_nodes * sd_nodes)) / sum));
  return weight;
}

/// Gaussian along one axis; the edge node continues outside.
void smoothAlong(const Lattice& g, int axis, double sd_mm, std::vector<float>& values, std::vector<float>& scratch) {
  const std::vector<float> weight = gaussian(sd_mm / g.spacing_mm[axis]);
  const int radius = static_cast<int>(weight.size()) - 1;
  forRows(g, [&](int j, int k, std::size_t row) {
    thread_local std::vector<float> padded;
    thread_local std::vector<const float*> rows;
    rows.clear();
    if (axis == 0) {
      padded.resize(g.size[0] + 2 * radius);
      for (int i = 0; i < g.size[0] + 2 * radius; ++i)
        padded[i] = values[row + std::clamp(i - radius, 0, g.size[0] - 1)];
      for (int o = 0; o <= 2 * radius; ++o) rows.push_back(padded.data() + o);
    } else {
      const int here = axis == 1 ? j : k;
      for (int o = -radius; o <= radius; ++o) {
        const int there = std::clamp(here + o, 0, g.size[axis] - 1) - here;
        rows.push_back(values.data() + row + std::ptrdiff_t(there) * std::ptrdiff_t(g.step[axis]));
      }
    }
    weighRows(rows, weight, {scratch.data() + row, std::size_t(g.size[0])});
  });
  values.swap(scratch);
}

/// Low-pass 2S - SS of a Gaussian S: it leaves outlines that bend slowly where they are, while S alone draws every
/// vessel inward, by most of a voxel where it is small (the idea of G. Taubin 1995).
void smoothWithoutShrinking(const Lattice& g, Vec3 sd_mm, std::vector<float>& d, std::vector<float>& scratch) {
  for (int axis = 0; axis < 3; ++axis) smoothAlong(g, axis, sd_mm[axis], d, scratch);
  const std::vector<float> once = d;
  for (int axis = 0; axis < 3; ++axis) smoothAlong(g, axis, sd_mm[axis], d, scratch);
  for (std::size_t n = 0; n < d.size(); ++n) d[n] = 2 * once[n] - d[n];
}

/// The smoothest outline that stays within half a voxel of the label map's: what a voxel does not resolve may be
/// rounded, what it does may not. (Constrained elastic surface nets, S. F. Gibson 1998, on distances.)
void roundStairs(const Lattice& g, Vec3 sd_mm, float freedom_mm, std::vector<float>& d, std::vector<float>& scratch) {
  constexpr int kRounds = 2;
  const std::vector<float> original = d;
  for (int round = 0; round < kRounds; ++round) {
    smoothWithoutShrinking(g, 1.3 * sd_mm, d, scratch);
    for (std::size_t n = 0; n < d.size(); ++n)
      d[n] = std::clamp(d[n], original[n] - freedom_mm, original[n] + freedom_mm);
  }
  // The clamp leaves creases of its own.
  smoothWithoutShrinking(g, 0.6 * sd_mm, d, scratch);
}

/// A structure hardly thicker than a voxel would be rounded away. Where nothing of it is left round one of its nodes,
/// the label map's outline stands: a vessel of one voxel is seen.
void keepThinStructures(const Lattice& g, const std::vector<std::uint8_t>& nodeLabel, const std::vector<float>& inside2,
                        float half_mm, TissueField& field) {
  std::array<int, 256> channelOf{};
  for (int c = 0; c < field.channels; ++c) channelOf[field.label[c]] = c;
  const auto own = [&](std::size_t n) { return field.distance[n].to[channelOf[nodeLabel[n]]]; };
  // Of a thin sheet that smoothing left outside of itself and of its neighbours alike, the nearest is seen.
  const auto nearest = [&](std::size_t n) {
    const std::int16_t* d = field.distance[n].to;
    return own(n) == *std::min_element(d, d + field.channels);
  };
  const auto survives = [&](int i, int j, int k, std::size_t n) {
    for (int z = std::max(k - 1, 0); z <= std::min(k + 1, g.size[2] - 1); ++z)
      for (int y = std::max(j - 1, 0); y <= std::min(j + 1, g.size[1] - 1); ++y)
        for (int x = std::max(i - 1, 0); x <= std::min(i + 1, g.size[0] - 1); ++x) {
          const std::size_t m = z * g.step[2] + y * g.step[1] + x;
          if (nodeLabel[m] == nodeLabel[n] && nearest(m)) return true;
        }
    return false;
  };
  std::vector<std::vector<std::size_t>> lost(g.size[2]);  // by slice, so that all are found before any is changed
  forRows(g, [&](int j, int k, std::size_t row) {
    for (int i = 0; i < g.size[0]; ++i)
      if (!nearest(row + i) && !survives(i, j, k, row + i)) lost[k].push_back(row + i);
  });
  for (const auto& slice : lost)
    for (const std::size_t n : slice) {
      const auto depth = static_cast<std::int16_t>(
          std::lround((std::sqrt(inside2[n]) - half_mm) * static_cast<float>(TissueField::kUnitsPerMm)));
      std::int16_t* d = field.distance[n].to;
      for (int c = 0; c < field.channels; ++c) d[c] = std::max(d[c], depth);
      d[channelOf[nodeLabel[n]]] = static_cast<std::int16_t>(-depth);
    }
}

}  // namespace

bool signedDistances(const std::vector<std::uint8_t>& nodeLabel, Vec3 nodeSpacing_mm, Vec3 smoothing_mm,
                     float freedom_mm, TissueField& field, const Progress& progress) {
  const Lattice g{
      field.size, {1, std::size_t(field.size[0]), std::size_t(field.size[0]) * field.size[1]}, nodeSpacing_mm};
  const std::size_t nodes = nodeLabel.size();
  // Distances run between node centres; the boundary lies half a node before.
  const auto half = static_cast<float>((nodeSpacing_mm.x + nodeSpacing_mm.y + nodeSpacing_mm.z) / 6);
  const auto unit = static_cast<float>(TissueField::kUnitsPerMm);

  TissueField::Distances far;
  std::ranges::fill(far.to, static_cast<std::int16_t>(kReach * unit));
  field.distance.assign(nodes, far);
  std::vector<float> a(nodes), b(nodes), inside2(nodes, kFar2);
  std::vector<std::vector<float>> outside(field.channels);
  for (int c = 0; c < field.channels; ++c) {
    if (!report(progress, "Measuring distances to structures", 0.3 * c / field.channels)) return false;
    distanceAlongX(g, nodeLabel, field.label[c], a);
    distanceAlong(g, 1, a, b);
    distanceAlong(g, 2, b, a);
    for (std::size_t n = 0; n < nodes; ++n)
      if (nodeLabel[n] != field.label[c]) inside2[n] = std::min(inside2[n], a[n]);
    outside[c] = a;
  }
  for (int c = 0; c < field.channels; ++c) {
    if (!report(progress, "Measuring distances to structures", 0.3 + 0.7 * c / field.channels)) return false;
    std::vector<float>& d = outside[c];
    for (std::size_t n = 0; n < nodes; ++n)
      d[n] = nodeLabel[n] == field.label[c] ? half - std::sqrt(inside2[n]) : std::sqrt(d[n]) - half;
    roundStairs(g, smoothing_mm, freedom_mm, d, a);
    for (std::size_t n = 0; n < nodes; ++n)
      field.distance[n].to[c] = static_cast<std::int16_t>(std::lround(d[n] * unit));
    d = {};
  }
  keepThinStructures(g, nodeLabel, inside2, half, field);
  return report(progress, "Measuring distances to structures", 1);
}

}  // namespace insonate
