#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/Procedure.h>

#include <cstdint>
#include <span>

namespace insonate {

/// Whether a procedure can be done on a case that has these `labels`. Fails with a sentence where a structure that it
/// needs is not labelled, and where the case's targets are those of another procedure that comes along. Targets whose
/// names tell of no procedure speak against none.
Result<void> checkFits(const Procedure& procedure, const CaseManifest& manifest, std::span<const std::uint8_t> labels);
/// The same, looking through the label map.
Result<void> checkFits(const Procedure& procedure, const PatientCase& patient);

}  // namespace insonate
