#include "store/StoreChecks.h"

#include "store/AuditChain.h"
#include "store/CurriculumRows.h"

namespace insonate::store {
namespace {

Error damaged(const std::string& place, const std::string& what) {
  return {place + " is damaged (" + what + "). Put a backup in its place."};
}

/// Verifies the pages of an SQLite file; a PostgreSQL server verifies its own pages and keys.
Result<void> verifyPages(Transaction& transaction) {
  if (transaction.dialect().name != "sqlite") return {};
  const auto pages = transaction.row("PRAGMA integrity_check(1)");
  if (pages && pages->text(0) != "ok") return tl::unexpected(damaged(transaction.place(), pages->text(0)));
  const auto keys = transaction.row("PRAGMA foreign_key_check");
  if (keys)
    return tl::unexpected(
        damaged(transaction.place(), "a row of " + keys->text(0) + " refers to a row that is missing"));
  return {};
}

Result<void> verifyCurricula(Transaction& transaction) {
  for (const CurriculumEntry& entry : listCurricula(transaction))
    if (const auto kept = findCurriculum(transaction, entry.name, entry.version))
      if (auto ok = checkHash(*kept); !ok) return ok;
  return {};
}

}  // namespace

Result<void> checkPages(Connection& connection) {
  if (connection.dialect().name != "sqlite") return {};
  const auto rows = connection.rows("PRAGMA quick_check(1)", {});
  if (!rows) return tl::unexpected(rows.error());
  if (rows->front().text(0) == "ok") return {};
  return tl::unexpected(damaged(connection.place(), rows->front().text(0)));
}

Result<void> verifyAll(Transaction& transaction) {
  if (auto ok = verifyPages(transaction); !ok) return ok;
  if (auto ok = verifyCurricula(transaction); !ok) return ok;
  return verifyAudit(transaction, {});
}

}  // namespace insonate::store
