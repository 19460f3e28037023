#pragma once

#include "store/site/Site.h"

namespace insonate::store {

/// Checks an item that was sent by a workstation without the password of the database. Fails if the item must not be
/// stored, or cannot be stored yet. Voids, acceptances and comments that the rules do not allow are removed from the
/// item; `troubles` then says so.
Result<void> applyRules(Transaction& server, const Core& core, const Sender& sender, SentItem& item,
                        std::vector<std::string>& troubles);

/// Lets an ended attempt of a workstation without the password of the database wait for its verification. An attempt
/// without a recording is unproven at once.
void awaitVerification(Transaction& server, const AttemptFacts& facts, std::int64_t now_us);

}  // namespace insonate::store
