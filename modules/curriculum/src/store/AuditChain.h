#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/AuditLog.h>

namespace insonate::store {

/// Adds an entry; the function fills in its number and hash. The transaction must be a writing one.
void appendAudit(Transaction& transaction, AuditEntry entry);

AuditAnchor auditEnd(Transaction& transaction);

/// Verifies the log like AuditLog::verify().
Result<void> verifyAudit(Transaction& transaction, const AuditAnchor& anchor);

/// Shortens a text that a user wrote to the length that a log entry allows.
std::string forLog(const std::string& text);

AuditEntry auditEntryOf(const Row& row);

}  // namespace insonate::store
