#include "store/Export.h"
#include "store/Session.h"
#include "store/StoreChecks.h"
#include "store/StoredRecordings.h"
#include "store/sql/FileCopy.h"
#include "store/sql/PrivateFile.h"

#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/StoreUpkeep.h>

#include <fstream>

namespace insonate {
namespace {

using store::Act;
using store::Actor;
using store::Transaction;

}  // namespace

Result<StoreFacts> StoreUpkeep::facts() const {
  return by_.session()->read(
      {.act = Act::LookAfterStore, .detail = "facts"},
      [&](Transaction& transaction, const Actor&) -> Result<StoreFacts> {
        return StoreFacts{.place = transaction.place(),
                          .schema = static_cast<int>(transaction.number("SELECT MAX(number) FROM schema_migrations")),
                          .people = transaction.number("SELECT COUNT(*) FROM people"),
                          .cohorts = transaction.number("SELECT COUNT(*) FROM cohorts"),
                          .attempts = transaction.number("SELECT COUNT(*) FROM attempts"),
                          .forms = transaction.number("SELECT COUNT(*) FROM forms"),
                          .auditEntries = transaction.number("SELECT COUNT(*) FROM audit"),
                          .pendingUploads = transaction.number("SELECT COUNT(*) FROM outbox")};
      });
}

Result<void> StoreUpkeep::verify() const {
  return by_.session()->read({.act = Act::LookAfterStore, .detail = "verify"},
                             [](Transaction& transaction, const Actor&) { return store::verifyAll(transaction); });
}

Result<void> StoreUpkeep::backup(const std::filesystem::path& file, const Progress& progress) const {
  store::Core& core = by_.session()->core();
  // Decides and logs first, so that the copy contains the entry.
  auto allowed = by_.session()->read({.act = Act::LookAfterStore, .detail = "backup to " + file.string()},
                                     [](Transaction&, const Actor&) -> Result<void> { return {}; });
  if (!allowed) return allowed;
  if (core.address().isServer) return fail(core.place() + " is a server; back it up with pg_dump, where it runs.");
  const auto connection = core.connection();
  if (!connection) return tl::unexpected(connection.error());
  // Renames the file once its recordings are complete. They are copied after the rows, whose recordings exist by then.
  return writeAtomically(file, [&](const std::filesystem::path& beside) -> Result<void> {
    if (auto copied = store::copyToFile(**connection, beside); !copied) return copied;
    return store::copyRecordings(core.recordings(), store::recordingsBeside(file), progress);
  });
}

Result<void> StoreUpkeep::exportJson(const std::filesystem::path& file) const {
  const auto text = by_.session()->read(
      {.act = Act::LookAfterStore, .detail = "export to " + file.string()},
      [](Transaction& transaction, const Actor&) -> Result<std::string> { return store::exported(transaction); });
  if (!text) return tl::unexpected(text.error());
  return writeAtomically(file, [&](const std::filesystem::path& beside) -> Result<void> {
    store::makePrivate(beside);
    std::ofstream stream(beside, std::ios::binary);
    if (!(stream << *text << std::flush)) return fail("Could not write " + beside.string() + ".");
    return {};
  });
}

}  // namespace insonate
