#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/AuditLog.h>

#include <string>
#include <vector>

namespace insonate::store {

/// Adds an entry to the audit log, with its number and hash. `transaction` must be one for writing.
void appendAudit(Transaction& transaction, AuditEntry entry);

AuditAnchor auditEnd(Transaction& transaction);

/// Verifies the audit log; see AuditLog::verify().
Result<void> verifyAudit(Transaction& transaction, const std::vector<AuditAnchor>& anchors);

/// Shortens a user's text to the length that an entry of the audit log allows.
std::string forLog(const std::string& text);

AuditEntry auditEntryOf(const Row& row);

}  // namespace insonate::store
