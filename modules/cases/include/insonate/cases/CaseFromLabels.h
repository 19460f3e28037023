#pragma once

#include <insonate/cases/CtSynthesis.h>
#include <insonate/cases/PatientCase.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

struct CaseFromLabelsResult {
  PatientCase patient;
  std::vector<std::string> notes;  ///< what was mapped, completed or could not be, one sentence each
};

/// Makes a case of anyone's label map (NRRD, NIfTI, MetaImage; axial slices): translates its numbers, completes what it
/// lacks and synthesises a CT. `mapFile` is JSON:
///   "labels"      {"109": "vein", "118": 8, ...}: the file's numbers to names or numbers of insonate/tissue/Labels.h
///   "others"      what numbers not listed become; without it they are refused
///   "title"       of the case
///   "crop_mm"     {"min": [x, y, z], "max": [x, y, z]}: the part to keep, patient LPS
///   "tubes"       [{"label": "airway and lung", "points_mm": [[x, y, z], ...], "radius_mm": 8 or one per point,
///                   "wall": "cartilage", "wall_mm": 1.8}]: structures the file lacks, drawn where nothing else is
///   "complete"    {"skin_mm": 1.8, "fat_mm": 5, "margin_mm": 2}: a body around the structures: skin, subcutaneous
///                 fat, and muscle, fat and connective tissue in between
///   "targets"     [{"name": "right internal jugular vein", "number": 109, "z_mm": -65}]: center of that number's
///                 voxels in the slice nearest to that level; each gets a transverse and a longitudinal start pose
///   "vessels"     {"109": "right internal jugular vein", ...}: the names of the file's vessels, by number
/// Fails with the file and the entry that is wrong; unknown entries are refused, and so is a map that lists no
/// structure or the numbers of less than half of the labeled voxels.
Result<CaseFromLabelsResult> caseFromLabels(const std::filesystem::path& labelFile,
                                            const std::filesystem::path& mapFile, const CtSynthesisOptions& ct,
                                            const Progress& progress = {});

}  // namespace insonate
