#pragma once

#include "DicomSlice.h"
#include "StackPlan.h"

#include <map>
#include <type_traits>
#include <vector>

namespace insonate {

/// Sorts slices into groups with the same key; within a group, slices keep their order.
template <class Key>
std::vector<std::vector<DicomSlice>> groupedBy(const std::vector<DicomSlice>& slices, Key key) {
  std::map<std::decay_t<std::invoke_result_t<Key, const DicomSlice&>>, std::vector<DicomSlice>> groups;
  for (const DicomSlice& s : slices) groups[key(s)].push_back(s);
  std::vector<std::vector<DicomSlice>> list;
  for (auto& [value, group] : groups) list.push_back(std::move(group));
  return list;
}

/// Returns the geometry of slices that all state position, orientation and pixel spacing; there must be at least one.
SliceStack stackOfSlices(const std::vector<DicomSlice>& slices);

/// Separates slices by their frames of reference. Some programs that remove the patient's identity give each slice a
/// frame of its own. Slices of different frames therefore stay together if they form one evenly spaced run and nothing
/// suggests that they come from several scans. Otherwise slices whose frames hold one slice each are combined into runs
/// as far as kernels, acquisitions, instance numbers and gaps separate these runs. All slices must state position,
/// orientation and pixel spacing.
std::vector<std::vector<DicomSlice>> splitByFrame(const std::vector<DicomSlice>& slices);

}  // namespace insonate
