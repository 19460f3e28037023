#include "store/CrashedAttempts.h"

#include "store/Core.h"
#include "store/Outbox.h"

#include <string>
#include <vector>

namespace insonate::store {
namespace {

std::vector<std::string> deadRuns(Transaction& transaction, const Core& core) {
  std::vector<std::string> dead;
  const auto rows = transaction.rows(
      "SELECT id, boot, pid, started FROM runs WHERE workstation = ? AND machine = ? "
      "AND EXISTS (SELECT 1 FROM attempts WHERE run = runs.id AND state = 'open')",
      core.workstation(), core.process().machine);
  for (const Row& row : rows) {
    const Process process{core.process().machine, row.text(1), row.number(2), row.number(3)};
    if (!process.isAlive()) dead.push_back(row.text(0));
  }
  return dead;
}

void abandonOf(Transaction& transaction, const Core& core, const std::string& run) {
  for (const Row& row : transaction.rows("SELECT id, person FROM attempts WHERE run = ? AND state = 'open'", run)) {
    transaction.run("UPDATE attempts SET state = 'abandoned', crashed = 1 WHERE id = ?", row.text(0));
    putIntoOutbox(transaction, core, "attempt", row.text(0));
    core.audit(transaction, "", "tell abandoned after a crash", row.text(1), row.text(0));
  }
}

}  // namespace

void storeRun(Transaction& transaction, const Core& core) {
  const Process& process = core.process();
  transaction.run("INSERT INTO runs VALUES (?, ?, ?, ?, ?, ?) ON CONFLICT (id) DO NOTHING", core.run(),
                  core.workstation(), process.machine, process.boot, process.pid, process.started);
}

Result<void> abandonCrashed(Core& core) {
  // Usually there are none, and no lock for writing is needed.
  const auto some = inTransaction(
      core, Way::Read, [&](Transaction& transaction) -> Result<bool> { return !deadRuns(transaction, core).empty(); });
  if (!some) return tl::unexpected(some.error());
  if (!*some) return {};
  return inTransaction(core, Way::Write, [&](Transaction& transaction) -> Result<void> {
    for (const std::string& run : deadRuns(transaction, core)) abandonOf(transaction, core, run);
    return {};
  });
}

}  // namespace insonate::store
