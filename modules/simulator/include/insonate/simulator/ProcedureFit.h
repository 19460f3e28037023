#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/Procedure.h>

#include <cstdint>
#include <span>

namespace insonate {

/// Checks that a procedure can be done on a case with these `labels`. Fails with a sentence if a structure that the
/// procedure needs is not labeled, or if the case's targets are those of another built-in procedure. Targets whose
/// names indicate no procedure are accepted.
Result<void> checkProcedureFits(const Procedure& procedure, const CaseManifest& manifest,
                                std::span<const std::uint8_t> labels);
/// Checks the same, for the labels that occur in the label map of `patient`.
Result<void> checkProcedureFits(const Procedure& procedure, const PatientCase& patient);

}  // namespace insonate
