#pragma once

#include "VesselSection.h"

#include <insonate/segmentation/CentreLine.h>

namespace insonate::segmentation {

/// Follows vessels of one label from section to section, and remembers which voxels belong to lines that are done.
class VesselTracer {
 public:
  VesselTracer(const LabelMap& labels, std::uint8_t label);

  /// A voxel that no line has gone by yet.
  bool isOpen(std::size_t offset) const { return voxels_[offset] == kOpen; }
  /// The line through the vessel at an open voxel, which is open no more, with all voxels beside the line; empty where
  /// there is too little, and where the volume's edge cuts the vessel and `evenCut` is not set.
  CentreLine trace(int i, int j, int k, bool evenCut);
  /// Opens again the sections that were deferred because they were cut.
  void reopen();

 private:
  /// States in the order in which one replaces another.
  enum : std::uint8_t { kOpen, kPutOff, kRim, kDone };
  struct Start {
    std::optional<VesselSection> section;
    Vec3 axis{0, 0, 1};
  };

  Start startAt(Vec3 from_mm);
  Start smallestAt(Vec3 at_mm);
  CentreLine follow(const VesselSection& start, Vec3 axis);
  void followToEdge(CentreLine& line, VesselSection last, Vec3 axis);
  bool isDone(Vec3 patient_mm) const;
  void mark(const VesselSection& section, std::uint8_t as);

  const LabelMap& labels_;
  std::uint8_t label_;
  SectionFinder finder_;
  Transform indexFromPatient_, patientFromIndex_;
  std::vector<std::uint8_t> voxels_;
  std::vector<VesselSection> trail_;  ///< of the line that is being followed
};

}  // namespace insonate::segmentation
