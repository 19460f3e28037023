#pragma once

#include "store/Core.h"

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/SiteUpload.h>

namespace insonate::store {

/// Sends people whom the server does not know yet, as disabled trainees; with another sign-in name if the name is
/// taken.
Result<void> sendPeople(Core& here, Core& server, UploadReport& report);

/// Sends all waiting attempts and forms to the server in batches. What the server has stored is removed from the
/// outbox.
Result<void> sendFacts(Core& here, Core& server, UploadReport& report, const Progress& progress);

}  // namespace insonate::store
