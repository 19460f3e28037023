#include "Islands.h"

#include <numeric>

namespace insonate::check {
namespace {

/// Neighboring voxels of one value along a row of the grid, ends included.
struct Run {
  int from, to;
  std::uint8_t value;
};

/// Runs of a volume, row after row, joined where rows beside each other touch (union-find with path halving).
class RunForest {
 public:
  RunForest(const LabelMap& labels, Joining joining) : labels_(labels), joining_(joining) {
    const auto& size = labels.geometry.size;
    rows_.push_back(0);
    for (int k = 0; k < size[2]; ++k)
      for (int j = 0; j < size[1]; ++j) {
        addRow(j, k);
        const std::size_t row = std::size_t(k) * std::size_t(size[1]) + std::size_t(j);
        if (j > 0) join(row - 1, row);
        if (k > 0) join(row - std::size_t(size[1]), row);
      }
  }

  std::vector<Island> islands() {
    std::vector<Island> found;
    std::vector<std::size_t> indexOf(runs_.size(), runs_.size());
    for (std::size_t row = 0; row + 1 < rows_.size(); ++row)
      for (std::size_t r = rows_[row]; r < rows_[row + 1]; ++r) {
        const std::size_t root = rootOf(r);
        if (indexOf[root] == runs_.size()) {
          indexOf[root] = found.size();
          const std::size_t first = row * std::size_t(labels_.geometry.size[0]) + std::size_t(runs_[r].from);
          found.push_back({labels_.voxels[first], 0, first});
        }
        found[indexOf[root]].voxels += std::size_t(runs_[r].to - runs_[r].from + 1);
      }
    return found;
  }

 private:
  std::uint8_t valueOf(std::uint8_t label) const { return joining_ == Joining::kOneLabel ? label : label != 0; }

  void addRow(int j, int k) {
    const std::uint8_t* voxel = &labels_.at(0, j, k);
    const int length = labels_.geometry.size[0];
    for (int i = 0; i < length;) {
      const std::uint8_t value = valueOf(voxel[i]);
      const int from = i;
      while (i < length && valueOf(voxel[i]) == value) ++i;
      if (value == 0) continue;
      parents_.push_back(runs_.size());
      runs_.push_back({from, i - 1, value});
    }
    rows_.push_back(runs_.size());
  }

  void join(std::size_t earlier, std::size_t later) {
    std::size_t a = rows_[earlier], b = rows_[later];
    while (a < rows_[earlier + 1] && b < rows_[later + 1]) {
      const Run &one = runs_[a], &other = runs_[b];
      if (one.value == other.value && one.from <= other.to && other.from <= one.to) parents_[rootOf(b)] = rootOf(a);
      one.to < other.to ? ++a : ++b;
    }
  }

  std::size_t rootOf(std::size_t run) {
    while (parents_[run] != run) run = parents_[run] = parents_[parents_[run]];
    return run;
  }

  const LabelMap& labels_;
  Joining joining_;
  std::vector<Run> runs_;
  std::vector<std::size_t> parents_, rows_;  ///< rows_[n]: the first run of row n
};

}  // namespace

std::vector<Island> islandsOf(const LabelMap& labels, Joining joining) {
  return RunForest(labels, joining).islands();
}

}  // namespace insonate::check
