#include "Checks.h"

#include <insonate/cases/Difficulty.h>

namespace insonate::check {

void checkDifficulty(const CaseView& patient, Findings& findings) {
  const std::string& given = patient.manifest.difficulty;
  if (patient.manifest.targets.empty()) {
    if (given.empty())
      findings.push_back(
          {FindingSeverity::kInfo, "difficulty_ungraded",
           "The case has no difficulty: its author has not graded it, and without a target it cannot be estimated."});
    return;
  }
  const auto estimate = estimateDifficulty(patient);
  const Vec3 place_mm = patient.manifest.targets.front().position_mm;
  const std::uint8_t label = patient.manifest.targets.front().label;
  if (!estimate) {
    if (given.empty())
      findings.push_back({FindingSeverity::kInfo, "difficulty_ungraded", estimate.error().message, place_mm, label});
    return;
  }
  if (given.empty())
    findings.push_back({FindingSeverity::kInfo, "difficulty_ungraded",
                        "The case has no grade by its author; the estimate applies. " + estimate->sentence, place_mm,
                        label});
  else if (given != estimate->grade)
    findings.push_back(
        {FindingSeverity::kInfo, "difficulty_differs",
         "The author's grade is " + given + "; the estimate from the labels differs. " + estimate->sentence, place_mm,
         label});
}

}  // namespace insonate::check
