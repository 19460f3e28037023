#pragma once

#include "VesselSection.h"

#include <insonate/segmentation/CenterLine.h>

namespace insonate::segmentation {

/// Finds the center lines of vessels of one label by stepping from cross-section to cross-section, and stores which
/// voxels belong to finished lines.
class VesselTracer {
 public:
  VesselTracer(const LabelMap& labels, std::uint8_t label);

  /// Tells whether a line can still start at the voxel with this offset: no traced line has passed it, and its section
  /// is not deferred.
  bool isOpen(std::size_t offset) const { return voxels_[offset] == kOpen; }
  /// Traces the center line of the vessel at the open voxel (i, j, k) and marks the voxels beside the line as no longer
  /// open. Returns an empty line if the vessel is too short. With `evenCut` false, also returns an empty line if the
  /// volume's edge cuts the section at the voxel; that section is then deferred.
  CenterLine trace(int i, int j, int k, bool evenCut);
  /// Marks the voxels of deferred sections as open again.
  void reopen();

 private:
  /// States of a voxel; each state may only be replaced by a later one.
  enum : std::uint8_t { kOpen, kPutOff, kRim, kDone };
  struct Start {
    std::optional<VesselSection> section;
    Vec3 axis{0, 0, 1};
  };

  Start startAt(Vec3 from_mm);
  Start smallestAt(Vec3 at_mm);
  CenterLine follow(const VesselSection& start, Vec3 axis);
  void followToEdge(CenterLine& line, VesselSection last, Vec3 axis);
  bool isDone(Vec3 patient_mm) const;
  void mark(const VesselSection& section, std::uint8_t as);

  const LabelMap& labels_;
  std::uint8_t label_;
  SectionFinder finder_;
  Transform indexFromPatient_, patientFromIndex_;
  std::vector<std::uint8_t> voxels_;
  std::vector<VesselSection> trail_;  ///< sections of the line that is being followed
};

}  // namespace insonate::segmentation
