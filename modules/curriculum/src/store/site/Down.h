#pragma once

#include "store/Core.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/SiteUpload.h>

namespace insonate::store {

/// Copies people, passwords, cohorts, curricula and voided attempts from the server to this store.
Result<void> fetchFromServer(Core& here, Core& server, UploadReport& report);

}  // namespace insonate::store
