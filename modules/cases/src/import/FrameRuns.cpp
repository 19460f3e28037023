#include "FrameRuns.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace insonate {
namespace {

using Slices = std::vector<DicomSlice>;

/// Depth of a slice along the normal of the first slice.
auto depthAlong(const Slices& slices) {
  const Vec3 normal = cross((*slices[0].orientation)[0], (*slices[0].orientation)[1]);
  return [normal](const DicomSlice& s) { return dot(*s.position_mm, normal); };
}

/// Tells whether slices with the same value are neighbors. Interleaved scans would alternate.
template <class Key>
bool isInBlocks(const Slices& ordered, Key key) {
  std::size_t blocks = 1;
  for (std::size_t n = 1; n < ordered.size(); ++n) blocks += key(ordered[n]) != key(ordered[n - 1]);
  return blocks == groupedBy(ordered, key).size();
}

int numberOfSlice(const DicomSlice& s) {
  return s.instance.value_or(0);
}

bool isNumberedInOrder(const Slices& ordered) {
  std::vector<int> numbers;
  std::ranges::transform(ordered, std::back_inserter(numbers), numberOfSlice);
  const bool same = std::ranges::all_of(numbers, [&](int number) { return number == numbers.front(); });
  return same || std::ranges::adjacent_find(numbers, std::ranges::greater_equal{}) == numbers.end() ||
         std::ranges::adjacent_find(numbers, std::ranges::less_equal{}) == numbers.end();
}

bool isOneRun(const Slices& slices) {
  constexpr std::size_t kFewest = 3;  // any two slices are evenly spaced
  if (slices.size() < kFewest || !isRun(stackOfSlices(slices))) return false;
  Slices ordered = slices;
  std::ranges::stable_sort(ordered, {}, depthAlong(slices));
  return isInBlocks(ordered, [](const DicomSlice& s) { return s.frameOfReferenceUid; }) &&
         isInBlocks(ordered, [](const DicomSlice& s) { return s.kernel; }) &&
         isInBlocks(ordered, [](const DicomSlice& s) { return s.acquisition; }) && isNumberedInOrder(ordered);
}

/// Separates where the steps along the stack, in the order of the instance numbers, turn back or change their length; a
/// missing slice leaves a multiple of the step.
std::vector<Slices> byOrder(const Slices& slices) {
  Slices numbered = slices;
  std::ranges::stable_sort(numbered, {}, numberOfSlice);
  const auto depth = depthAlong(slices);
  std::vector<Slices> runs{{numbered.front()}};
  for (std::size_t n = 1; n < numbered.size(); ++n) {
    const Slices& run = runs.back();
    const double step_mm = depth(numbered[n]) - depth(numbered[n - 1]);
    const double ratio = run.size() > 1 ? step_mm / (depth(run[1]) - depth(run[0])) : 1;
    constexpr double kSameStep = 0.2;
    if (!(ratio > 1 - kSameStep && std::abs(ratio - std::round(ratio)) < kSameStep)) runs.emplace_back();
    runs.back().push_back(numbered[n]);
  }
  return runs;
}

std::vector<Slices> byGap(const Slices& slices) {
  Slices ordered = slices;
  const auto depth = depthAlong(slices);
  std::ranges::stable_sort(ordered, {}, depth);
  std::vector<Slices> runs{{ordered.front()}};
  for (std::size_t n = 1; n < ordered.size(); ++n) {
    if (depth(ordered[n]) - depth(ordered[n - 1]) > kLargestFilledGap_mm + kSamePlace_mm) runs.emplace_back();
    runs.back().push_back(ordered[n]);
  }
  return runs;
}

/// Uses each way of separating once, beginning with number `way`; slices that form no run stay single.
std::vector<Slices> runsOf(const Slices& slices, int way = 0) {
  if (isOneRun(slices)) return {slices};
  std::vector<Slices> parts;
  switch (way) {
    case 0:
      parts = groupedBy(slices, [](const DicomSlice& s) { return s.kernel; });
      break;
    case 1:
      parts = groupedBy(slices, [](const DicomSlice& s) { return s.acquisition; });
      break;
    case 2:
      parts = byOrder(slices);
      break;
    case 3:
      parts = byGap(slices);
      break;
    default:
      for (const DicomSlice& s : slices) parts.push_back({s});
      return parts;
  }
  std::vector<Slices> runs;
  for (const Slices& part : parts) std::ranges::move(runsOf(part, way + 1), std::back_inserter(runs));
  return runs;
}

}  // namespace

SliceStack stackOfSlices(const std::vector<DicomSlice>& slices) {
  const DicomSlice& first = slices.front();
  SliceStack stack;
  stack.columns = first.columns;
  stack.rows = first.rows;
  stack.spacing_mm = {(*first.pixelSpacing_mm)[1], (*first.pixelSpacing_mm)[0]};
  stack.thickness_mm = first.thickness_mm.value_or(0);
  Vec3 i, j;
  for (const DicomSlice& s : slices) {
    i = i + (*s.orientation)[0];
    j = j + (*s.orientation)[1];
    stack.positions_mm.push_back(*s.position_mm);
  }
  stack.direction = {normalized(i), normalized(j)};
  return stack;
}

std::vector<std::vector<DicomSlice>> splitByFrame(const std::vector<DicomSlice>& slices) {
  const auto frames = groupedBy(slices, [](const DicomSlice& s) { return s.frameOfReferenceUid; });
  if (frames.size() == 1 || isOneRun(slices)) return {slices};
  std::vector<Slices> parts;
  Slices alone;
  for (const Slices& frame : frames) {
    if (frame.size() == 1)
      alone.push_back(frame.front());
    else
      parts.push_back(frame);
  }
  if (!alone.empty()) std::ranges::move(runsOf(alone), std::back_inserter(parts));
  return parts;
}

}  // namespace insonate
