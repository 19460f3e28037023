#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/procedure/AttemptHeader.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/ultrasound/Probe.h>

#include <string>
#include <string_view>

namespace insonate {

/// Of what the servo and pictures are computed from, a Fingerprint of sizes, CT and labels. Some tenths of a second for
/// a large CT.
std::string caseHashOf(const PatientCase& patient);

/// Begun now; without hashes and engine. `software` is name and version.
AttemptHeader headerOf(const Procedure& procedure, const PatientCase& patient, const Probe& probe,
                       std::string_view software);

}  // namespace insonate
