#pragma once

#include <insonate/cases/CaseView.h>
#include <insonate/core/Progress.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

enum class FindingSeverity { kError, kWarning, kInfo };

/// "error", "warning" or "info".
std::string_view nameOf(FindingSeverity severity);

/// One reason why a case is fit or unfit for training.
struct Finding {
  FindingSeverity severity;
  std::string code;                ///< stable, for scripts, e.g. "no_vein"
  std::string text;                ///< a sentence: what, where, what to do
  std::optional<Vec3> place_mm{};  ///< patient LPS, where it has one place; may lie outside the volume
  std::uint8_t label = 0;          ///< the structure it is about; 0 for none
};

/// Looks for everything that would make training on this case fail or mislead. Volumes must be on one grid.
/// Fails only when cancelled.
Result<std::vector<Finding>> checkCase(const CaseView& patient, const Progress& progress = {});

/// Tells whether there are no errors; warnings do not count.
bool isFit(const std::vector<Finding>& findings);

}  // namespace insonate
