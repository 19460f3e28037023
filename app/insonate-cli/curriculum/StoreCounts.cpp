#include "StoreCounts.h"

namespace insonate::cli {

Json countsJson(const StoreFacts& facts) {
  return {{"database", facts.place},
          {"schema", facts.schema},
          {"people", facts.people},
          {"classes", facts.cohorts},
          {"attempts", facts.attempts},
          {"forms", facts.forms},
          {"audit_entries", facts.auditEntries},
          {"pending_uploads", facts.pendingUploads}};
}

std::string countsOf(const StoreFacts& facts) {
  return std::to_string(facts.people) + " people, " + std::to_string(facts.cohorts) + " classes, " +
         std::to_string(facts.attempts) + " attempts, " + std::to_string(facts.forms) + " forms, " +
         std::to_string(facts.auditEntries) + " entries in the audit log";
}

}  // namespace insonate::cli
