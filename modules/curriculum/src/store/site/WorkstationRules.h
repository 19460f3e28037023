#pragma once

#include "store/site/Site.h"

namespace insonate::store {

/// Checks an item of a workstation that has no password of the database. Fails if the item must not be stored, or not
/// yet. Voids, acceptances and comments that are not taken over are removed from the item; `troubles` then says so.
Result<void> applyRules(Transaction& server, const Core& core, const Sender& sender, SentItem& item,
                        std::vector<std::string>& troubles);

/// Lets the ended attempt of such a workstation wait for its verification; an attempt without a recording is unproven
/// at once.
void awaitVerification(Transaction& server, const AttemptFacts& facts, std::int64_t now_us);

}  // namespace insonate::store
