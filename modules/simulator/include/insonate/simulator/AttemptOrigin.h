#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/ultrasound/Probe.h>

#include <string_view>

namespace insonate {

/// Makes the header of an attempt that begins now. The header has no hashes and no engine yet. `software` is name and
/// version.
AttemptHeader headerOf(const Procedure& procedure, const PatientCase& patient, const Probe& probe,
                       std::string_view software);

}  // namespace insonate
