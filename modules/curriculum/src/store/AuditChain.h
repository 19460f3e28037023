#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/AuditLog.h>

namespace insonate::store {

/// Adds an entry, whose number and hash are found here. In a transaction that writes.
void appendAudit(Transaction& transaction, AuditEntry entry);

AuditAnchor auditEnd(Transaction& transaction);

/// Verifies the log like AuditLog::verify().
Result<void> verifyAudit(Transaction& transaction, const AuditAnchor& anchor);

/// Another's words, cut to what an entry holds of each.
std::string forLog(const std::string& text);

AuditEntry auditEntryOf(const Row& row);

}  // namespace insonate::store
