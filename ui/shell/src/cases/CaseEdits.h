#pragma once

#include <insonate/ui/Workspace.h>

namespace insonate::ui {

/// Returns the case itself, or a copy with the edits if there are any. Call it on a background thread.
inline std::shared_ptr<const PatientCase> withEdits(std::shared_ptr<const PatientCase> patient,
                                                    const std::vector<CaseEdit>& edits) {
  if (edits.empty()) return patient;
  auto copy = std::make_shared<PatientCase>(*patient);
  for (const CaseEdit& edit : edits) edit(*copy);
  return copy;
}

}  // namespace insonate::ui
