#include "store/Outbox.h"

#include "store/Core.h"

namespace insonate::store {

void putIntoOutbox(Transaction& transaction, const Core& core, const std::string& kind, const std::string& id) {
  if (core.address().isServer) return;
  transaction.run("UPDATE site SET outbox_number = outbox_number + 1");
  transaction.run("DELETE FROM outbox WHERE kind = ? AND id = ?", kind, id);
  transaction.run("INSERT INTO outbox SELECT outbox_number, ?, ?, ? FROM site", kind, id, core.now_us());
}

}  // namespace insonate::store
