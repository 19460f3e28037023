#pragma once

#include "store/Core.h"

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/SiteUpload.h>

namespace insonate::store {

/// Sends people whom the server does not know yet, as disabled trainees; under another name if a person's name is
/// taken.
Result<void> sendPeople(Core& here, Core& server, UploadReport& report);

/// Sends all waiting facts in batches. Facts that the server has stored are removed from the outbox.
Result<void> sendFacts(Core& here, Core& server, UploadReport& report, const Progress& progress);

}  // namespace insonate::store
