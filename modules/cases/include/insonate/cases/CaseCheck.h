#pragma once

#include <insonate/cases/CaseView.h>
#include <insonate/core/Progress.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

enum class FindingSeverity { kError, kWarning, kInfo };

/// Returns "error", "warning" or "info".
std::string_view nameOf(FindingSeverity severity);

/// A result of checkCase(): one error, warning or remark about a case.
struct Finding {
  FindingSeverity severity;
  std::string code;                ///< stable identifier of the finding, for scripts, e.g. "no_vein"
  std::string text;                ///< sentence that says what is wrong, where, and what to do
  std::optional<Vec3> place_mm{};  ///< patient LPS, if the finding has a single position; may lie outside the volume
  std::uint8_t label = 0;          ///< the structure that the finding concerns; 0 for none
};

/// Checks a case for problems that would prevent training on it, or make training misleading. CT and labels must be on
/// one grid. Fails only when cancelled.
Result<std::vector<Finding>> checkCase(const CaseView& patient, const Progress& progress = {});

/// Tells whether the case with these findings is fit for training: none of the findings is an error.
bool isFitForTraining(const std::vector<Finding>& findings);

}  // namespace insonate
