#pragma once

#include "store/Core.h"

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/SiteUpload.h>

namespace insonate::store {

/// Sends people whom the server does not know yet, as disabled trainees; under another name if theirs is taken.
Result<void> sendPeople(Core& here, Core& server, UploadReport& report);

/// All that waits, in batches. What the server has now waits no more.
Result<void> sendFacts(Core& here, Core& server, UploadReport& report, const Progress& progress);

}  // namespace insonate::store
