#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/ultrasound/Probe.h>

#include <string_view>

namespace insonate {

/// Makes the header of the recording of an attempt that begins now. The caller adds hashes and engine, which are empty.
/// `software`: name and version of the program.
AttemptHeader headerOf(const Procedure& procedure, const PatientCase& patient, const Probe& probe,
                       std::string_view software);

}  // namespace insonate
