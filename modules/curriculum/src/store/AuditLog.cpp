#include "store/AuditChain.h"
#include "store/Paging.h"
#include "store/Session.h"

#include <insonate/curriculum/AuditLog.h>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Transaction;

}  // namespace

Result<std::vector<AuditEntry>> AuditLog::page(int count, std::int64_t before, const std::string& person) const {
  if (auto ok = store::checkPage(count); !ok) return tl::unexpected(ok.error());
  return by_.session()->read({.act = Act::SeeAudit, .person = person},
                             [&](Transaction& transaction, const Actor&) -> Result<std::vector<AuditEntry>> {
                               std::vector<AuditEntry> page;
                               for (const auto& row : transaction.rows(
                                        "SELECT * FROM audit WHERE number < ? AND (? = '' OR person = ? OR "
                                        "actor = ? OR detail LIKE ?) ORDER BY number DESC LIMIT ?",
                                        store::endOfPage(before), person, person, person, "%" + person + "%", count))
                                 page.push_back(store::auditEntryOf(row));
                               return page;
                             });
}

Result<AuditAnchor> AuditLog::anchor() const {
  return by_.session()->read(
      {.act = Act::SeeAudit, .detail = "anchor"},
      [](Transaction& transaction, const Actor&) -> Result<AuditAnchor> { return store::auditEnd(transaction); });
}

Result<void> AuditLog::verify(const std::vector<AuditAnchor>& anchors) const {
  return by_.session()->read({.act = Act::SeeAudit, .detail = "verify"}, [&](Transaction& transaction, const Actor&) {
    return store::verifyAudit(transaction, anchors);
  });
}

}  // namespace insonate
