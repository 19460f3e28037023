#include "store/KeptRecordings.h"
#include "store/PersonErasure.h"

#include <insonate/curriculum/ErasedAttempts.h>

namespace insonate {

Result<std::vector<std::string>> ErasedAttempts::removeRecordings() {
  using store::Transaction;
  using Attempts = std::vector<std::string>;
  store::Core& core = *store_.core_;
  std::int64_t erasures = 0;
  auto attempts = inTransaction(core, store::Way::Read, [&](Transaction& transaction) -> Result<Attempts> {
    erasures = transaction.number("SELECT COUNT(*) FROM erasures");
    return erasures == erasures_ ? Attempts() : store::erasedAttempts(transaction);
  });
  if (!attempts) return attempts;
  if (auto removed = store::removeRecordings(core.recordings(), *attempts); !removed)
    return tl::unexpected(removed.error());
  erasures_ = erasures;
  return attempts;
}

}  // namespace insonate
