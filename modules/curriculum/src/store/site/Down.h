#pragma once

#include "store/Core.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/SiteUpload.h>

namespace insonate::store {

/// People, passwords, cohorts, curricula and voidings as the server has them.
Result<void> fetchFromServer(Core& here, Core& server, UploadReport& report);

}  // namespace insonate::store
