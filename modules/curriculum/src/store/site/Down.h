#pragma once

#include "store/Core.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/SiteUpload.h>

namespace insonate::store {

/// Copies people, passwords, cohorts, curricula and voids of attempts from the server's database to the workstation's
/// (`here`).
Result<void> fetchFromServer(Core& here, Core& server, UploadReport& report);

}  // namespace insonate::store
