#include "store/PersonErasure.h"
#include "store/StoredRecordings.h"

#include <insonate/curriculum/ErasedAttempts.h>

#include <string>
#include <utility>
#include <vector>

namespace insonate {

Result<FilesToDelete> ErasedAttempts::removeRecordings() {
  using store::Transaction;
  using Attempts = std::vector<std::string>;
  store::Core& core = *store_.core_;
  std::int64_t erasures = 0;
  auto attempts = inTransaction(core, store::Way::Read, [&](Transaction& transaction) -> Result<Attempts> {
    erasures = transaction.number("SELECT COUNT(*) FROM erasures");
    return erasures == erasures_ ? Attempts() : store::erasedAttempts(transaction);
  });
  if (!attempts) return tl::unexpected(attempts.error());
  FilesToDelete files{.attempts = *std::move(attempts)};
  files.recordings = store::removeRecordings(core.recordings(), files.attempts);
  if (files.recordings) erasures_ = erasures;
  return files;
}

}  // namespace insonate
