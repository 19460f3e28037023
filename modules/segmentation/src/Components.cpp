#include "Components.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>

namespace insonate::segmentation {
namespace {

/// Disjoint sets; the root of a set is its first run, so that numbering does not depend on the order of joins.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0U); }

  std::uint32_t root(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = root(a), b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

using Runs = std::vector<Components::Run>;

void appendRuns(const std::uint8_t* row, int n, int j, int k, Runs& runs) {
  const std::uint8_t* const end = row + n;
  for (const std::uint8_t* at = row; (at = std::find(at, end, 1)) != end;) {
    const std::uint8_t* stop = std::find(at, end, 0);
    runs.push_back({static_cast<int>(at - row), static_cast<int>(stop - row), j, k, 0});
    at = stop;
  }
}

/// Joins the overlapping runs of two rows, each given as [begin, end) of the list.
void joinRows(const Runs& runs, std::size_t a, std::size_t aEnd, std::size_t b, std::size_t bEnd, Sets& sets) {
  while (a < aEnd && b < bEnd) {
    if (runs[a].begin < runs[b].end && runs[b].begin < runs[a].end)
      sets.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
    if (runs[a].end < runs[b].end)
      ++a;
    else
      ++b;
  }
}

}  // namespace

Components::Components(const Mask& mask, Reach reach, Work& work) {
  const auto [ni, nj, nk] = mask.geometry.size;
  std::vector<Runs> perSlice(nk);
  work.slices(nk, [&, ni = ni, nj = nj](int k) {
    for (int j = 0; j < nj; ++j) appendRuns(&mask.at(0, j, k), ni, j, k, perSlice[k]);
  });
  for (Runs& slice : perSlice) {
    runs_.insert(runs_.end(), slice.begin(), slice.end());
    Runs().swap(slice);
  }

  // firstRun[row] .. firstRun[row + 1] are the runs of a row.
  std::vector<std::size_t> firstRun(std::size_t(nj) * nk + 1, 0);
  for (const Run& run : runs_) ++firstRun[std::size_t(run.k) * nj + run.j + 1];
  std::partial_sum(firstRun.begin(), firstRun.end(), firstRun.begin());

  Sets sets(runs_.size());
  for (int k = 0; k < nk; ++k) {
    for (int j = 0; j < nj; ++j) {
      const std::size_t row = std::size_t(k) * nj + j;
      const auto joinWith = [&](std::size_t other) {
        joinRows(runs_, firstRun[row], firstRun[row + 1], firstRun[other], firstRun[other + 1], sets);
      };
      if (j > 0) joinWith(row - 1);
      if (k > 0 && reach == Reach::Volume) joinWith(row - nj);
    }
    work.checkpoint();
  }

  for (std::uint32_t r = 0; r < runs_.size(); ++r) {
    const std::uint32_t root = sets.root(r);
    runs_[r].component = root == r ? count_++ : runs_[root].component;
  }
}

std::vector<std::size_t> Components::sizes() const {
  std::vector<std::size_t> sizes(count_, 0);
  for (const Run& run : runs_) sizes[run.component] += run.end - run.begin;
  return sizes;
}

std::uint32_t Components::componentAt(int i, int j, int k) const {
  const auto after = std::ranges::upper_bound(runs_, std::array{k, j, i}, {}, [](const Run& run) {
    return std::array{run.k, run.j, run.begin};
  });
  return std::prev(after)->component;
}

void Components::paint(const std::vector<bool>& chosen, std::uint8_t value, Volume<std::uint8_t>& target) const {
  for (const Run& run : runs_)
    if (chosen[run.component])
      std::fill(&target.at(run.begin, run.j, run.k), &target.at(run.begin, run.j, run.k) + (run.end - run.begin),
                value);
}

}  // namespace insonate::segmentation
