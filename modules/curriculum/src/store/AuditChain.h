#pragma once

#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/AuditLog.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate::store {

/// Adds an entry to the audit log, with its number and hash. `transaction` must be one for writing.
void appendAudit(Transaction& transaction, AuditEntry entry);

AuditAnchor auditEnd(Transaction& transaction);

/// Verifies the audit log; see AuditLog::verify(). An entry whose detail was erased does not give its own hash any
/// more. It is accepted if a later entry with the act kEraseDetail vouches for its other fields.
Result<void> verifyAudit(Transaction& transaction, const std::vector<AuditAnchor>& anchors);

/// The beginning of a detail from which a text was erased.
inline constexpr std::string_view kErased = "(erased)";
inline constexpr std::string_view kEraseDetail = "erase log detail";
/// Tells whether an entry gives its hash. `hashBefore`: hash of the former entry.
bool isAsWritten(const AuditEntry& entry, const std::string& hashBefore);
/// Returns the detail of the entry that vouches for an entry with an erased detail: number and SHA-256 of all fields.
std::string voucherFor(const AuditEntry& entry);

/// Shortens a user's text to the length that an entry of the audit log allows.
std::string forLog(const std::string& text);

AuditEntry auditEntryOf(const Row& row);

}  // namespace insonate::store
