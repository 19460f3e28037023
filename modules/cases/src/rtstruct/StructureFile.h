#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>
#include <insonate/tissue/Labels.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace insonate {

/// Corners of a closed contour, patient LPS, mm.
using ContourCorners = std::vector<Vec3>;

struct DrawnStructure {
  std::int32_t number = 0;               ///< number in the file (ROI Number)
  std::string name;                      ///< may contain patient data
  std::size_t otherContours = 0;         ///< points and open contours, which are left out
  std::string algorithm;                 ///< how it was drawn: "AUTOMATIC", "SEMIAUTOMATIC", "MANUAL", or empty
  std::string type;                      ///< interpreted type, e.g. "ORGAN", "EXTERNAL", or empty
  std::vector<ContourCorners> contours;  ///< closed planar contours of three corners or more
  std::size_t withoutArea = 0;           ///< closed contours of fewer than three corners
  std::optional<LabelColor> color;
  std::string damage;  ///< "has a contour that ..." if a contour cannot be read; else empty
};

/// The content of an RT Structure Set (PS3.3 A.19).
struct StructureSet {
  std::vector<DrawnStructure> structures;
  std::set<std::string> seriesUids;  ///< CT series on which the structures were drawn, if stated; identify the patient
                                     ///< and must not be stored
};

/// Fails on files that are truncated, not structure sets, or that contain no structures.
Result<StructureSet> readStructureFile(const std::filesystem::path& file);

}  // namespace insonate
