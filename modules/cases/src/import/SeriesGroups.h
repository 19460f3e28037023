#pragma once

#include "DicomSlice.h"
#include "StackPlan.h"

#include <string>
#include <vector>

namespace insonate {

/// DICOM slices that form one volume; in the order of `plan` if they can be stacked.
struct DicomSeries {
  std::string uid;  ///< Series Instance UID, with "#2" when one UID holds several stacks
  std::string modality;
  std::vector<DicomSlice> slices;
  SliceStack stack;
  StackPlan plan;
  std::vector<std::string> warnings;  ///< warnings about the series, including those of `plan`
  std::string refusal;
};

/// Sorts slices into series. The Series Instance UID alone is not sufficient: slices of one UID that differ in study,
/// size, pixel spacing or orientation, or that occupy the same positions twice, form different series. Slices that
/// differ only in their frame of reference are one series if they form one evenly spaced run, with a warning.
std::vector<DicomSeries> groupSlices(const std::vector<DicomSlice>& slices);

}  // namespace insonate
