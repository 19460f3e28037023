#pragma once

#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/Import.h>
#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// The series of a study from which a case is made.
struct Study {
  std::filesystem::path folder;  ///< folder or file that holds the study
  SeriesInfo series;             ///< the chosen series
  std::string id;                ///< 16 hexadecimal digits, from the series; contains no data of the patient
  std::string choice;            ///< sentence on why this series was chosen; empty if there was only one
};

/// Finds the series of a study that is best suited for a case: a CT that can be imported, with the smallest distance
/// between slices among those that show at least 60 mm, or else the longest. Two studies with the same series have the
/// same id, wherever their folders lie. A volume file has no UID; its id depends on its path. Fails if no series can be
/// imported, with the reasons.
Result<Study> findStudy(const std::filesystem::path& folder, const Progress& progress = {});

/// A case that was prepared without an author, for an author to confirm.
struct PreparedStudy {
  PatientCase patient;
  std::vector<std::string> warnings;  ///< points that the author should look at, one sentence each
  std::vector<Finding> findings;      ///< result of the check
};

/// Does all of an author's work that needs no author: imports the series, adds the offset that its values probably
/// lack, labels skin, bone, airway, fat and muscle, proposes targets and start poses, and checks the case. The title is
/// "Case" with the first digits of the id. Fails as importSeries() and autoLabel() do, and if values saturate.
Result<PreparedStudy> prepareStudy(const Study& study, const Progress& progress = {});

}  // namespace insonate
