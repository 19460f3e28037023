#pragma once

#include <insonate/cases/CtSynthesis.h>
#include <insonate/cases/PatientCase.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

struct CaseFromLabelsResult {
  PatientCase patient;
  std::vector<std::string> notes;  ///< changes and problems of the conversion, one sentence each
};

/// Makes a case from the label map of another program (NRRD, NIfTI or MetaImage, axial slices): translates the numbers
/// of its labels, adds missing structures and synthesizes a CT. `mapFile` is a JSON file with these entries:
///   "labels"      {"109": "vein", "118": 8, ...}: the file's numbers, each with a name or number of
///                 insonate/tissue/Labels.h
///   "others"      the label for numbers that are not listed; without it such numbers are refused
///   "title"       the title of the case
///   "crop_mm"     {"min": [x, y, z], "max": [x, y, z]}: the part to keep, patient LPS
///   "tubes"       [{"label": "airway and lung", "points_mm": [[x, y, z], ...], "radius_mm": 8 or one per point,
///                   "wall": "cartilage", "wall_mm": 1.8}]: missing structures, drawn into unlabeled voxels
///   "complete"    {"skin_mm": 1.8, "fat_mm": 5, "margin_mm": 2}: a body around the structures: skin, subcutaneous
///                 fat, and muscle, fat and connective tissue in between
///   "targets"     [{"name": "right internal jugular vein", "number": 109, "z_mm": -65}]: center of that number's
///                 voxels in the slice nearest to that level; each gets a transverse and a longitudinal start pose
///   "vessels"     {"109": "right internal jugular vein", ...}: the names of the file's vessels, by number
/// Fails with a sentence that names the file and the invalid entry. Refuses unknown entries, a map file that lists no
/// structure, and a map file whose numbers cover less than half of the labeled voxels.
Result<CaseFromLabelsResult> caseFromLabels(const std::filesystem::path& labelFile,
                                            const std::filesystem::path& mapFile, const CtSynthesisOptions& ct,
                                            const Progress& progress = {});

}  // namespace insonate
