#pragma once

#include <insonate/cases/LabelFile.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// A structure of a DICOM RT Structure Set, for the user to choose.
struct ListedStructure {
  std::int32_t number = 0;        ///< number in the file (ROI Number)
  std::string name;               ///< may contain patient data
  std::size_t contours = 0;       ///< closed planar contours, which can be read
  std::size_t otherContours = 0;  ///< points and open contours, which are left out
  std::string algorithm;          ///< how it was drawn: "AUTOMATIC", "SEMIAUTOMATIC", "MANUAL", or empty
  std::string type;               ///< interpreted type, e.g. "ORGAN", "EXTERNAL", or empty
};

/// Tells whether a file states that it is a DICOM RT Structure Set.
bool isStructureSet(const std::filesystem::path& file);

/// Lists the structures in the order of the file. Fails if the file is not a complete RT Structure Set or has no
/// structures.
Result<std::vector<ListedStructure>> listStructures(const std::filesystem::path& file);

/// Reads the structures with these numbers (all if `numbers` is empty) as labels on the grid of the case's CT. A voxel
/// belongs to a structure if its center lies in an odd number of the contours of its slice. Between contoured slices
/// at most 10 mm apart, up to three slices without contours get an interpolated shape, with a note. Structures are
/// identified and named as importLabels() does; where structures overlap, the later one in the file replaces the
/// earlier one, and the outline of the body (type EXTERNAL) lies below all others. Structures without closed contours,
/// or whose contours do not lie in parallel planes, are left out with a note. Fails without a result if the file or a
/// chosen structure is damaged, or if no chosen structure lies in the CT.
Result<LabelReadResult> readStructureSet(const PatientCase& patient, const std::filesystem::path& file,
                                         const std::vector<std::int32_t>& numbers = {}, const Progress& progress = {});

}  // namespace insonate
