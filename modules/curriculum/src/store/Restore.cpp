#include "store/AdministratorProof.h"
#include "store/AuditChain.h"
#include "store/Migrations.h"
#include "store/StoreChecks.h"
#include "store/StoredRecordings.h"
#include "store/sql/FileCopy.h"

#include <insonate/curriculum/StoreUpkeep.h>

#include <unistd.h>

#include <optional>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using store::Address;
using store::Connection;
using store::Core;
using store::Transaction;
using store::Way;

fs::path with(const fs::path& file, const char* ending) {
  return fs::path(file.string() + ending);
}

/// The file of a database and the two that SQLite adds.
constexpr const char* kParts[] = {"", "-wal", "-shm"};

/// A copy of a backup to check, migrate and rename; deleted at the end unless it was renamed.
struct Candidate {
  explicit Candidate(const fs::path& target)
      : file(with(target, (".restoring-" + std::to_string(::getpid())).c_str())) {}
  ~Candidate() {
    std::error_code ignored;
    for (const char* part : kParts) fs::remove(with(file, part), ignored);
    for (int schema = 1; schema <= store::newestSchema(); ++schema)
      fs::remove(store::copyBeforeMigration(file, schema), ignored);
  }
  Candidate(const Candidate&) = delete;
  Candidate& operator=(const Candidate&) = delete;

  const fs::path file;
};

/// The person who restores, for the log of the backup.
struct Restorer {
  std::string id{}, detail{};
};

/// An administrator of the store to be replaced; none if there is nobody to ask.
Result<std::optional<Restorer>> askReplaced(const fs::path& file, const std::string& administrator,
                                            const std::string& password) {
  const auto core = Core::reach(file.string(), {});
  if (!core) return tl::unexpected(core.error());
  if (const auto some = store::hasPeople(**core); !some || !*some) return std::nullopt;
  const auto known = store::proveAdministrator(**core, administrator, password);
  if (!known) return tl::unexpected(known.error());
  return inTransaction(**core, Way::Read, [&](Transaction& transaction) -> Result<std::optional<Restorer>> {
    const AuditAnchor end = store::auditEnd(transaction);
    return Restorer{known->id, "over a store whose log ends at " + std::to_string(end.number) + " " + end.hash};
  });
}

/// Checks that the pages of the backup are readable and its log is consistent. If no person of the replaced store
/// restores it, an administrator of the backup must do so. Adds an entry to the backup's log.
Result<void> checkCandidate(const fs::path& file, std::optional<Restorer> restorer, const std::string& administrator,
                            const std::string& password) {
  const auto core = Core::open(file.string(), {});
  if (!core) return tl::unexpected(core.error());
  if (!restorer) {
    const auto known = store::proveAdministrator(**core, administrator, password);
    if (!known) return tl::unexpected(known.error());
    restorer = Restorer{known->id, ""};
  }
  return inTransaction(**core, Way::Write, [&](Transaction& transaction) -> Result<void> {
    if (auto ok = store::verifyAll(transaction); !ok) return ok;
    (*core)->audit(transaction, restorer->id, "restore backup", "", restorer->detail);
    return {};
  });
}

bool isWhole(const fs::path& file) {
  if (!fs::exists(file)) return false;
  const auto connection = Connection::open(*Address::parse(file.string()));
  return connection && store::checkPages(**connection);
}

/// Overwrites a database that other processes may have open, as one transaction.
Result<void> writeOver(const fs::path& file, const fs::path& candidate) {
  const auto to = Connection::open(*Address::parse(file.string()));
  if (!to) return tl::unexpected(to.error());
  if (auto kept = store::copyToFile(**to, with(file, ".before-restore")); !kept) return kept;
  const auto from = Connection::open(*Address::parse(candidate.string()));
  if (!from) return tl::unexpected(from.error());
  return store::copyInto(**from, **to);
}

/// Replaces a file that is missing or damaged.
Result<void> moveInto(const fs::path& file, const fs::path& candidate) {
  std::error_code error;
  for (const char* part : kParts)
    if (fs::exists(with(file, part)))
      fs::rename(with(file, part), with(file, ".before-restore").string() + part, error);
  if (!error) fs::rename(candidate, file, error);
  if (error) return fail("Could not put the backup in the place of " + file.string() + ": " + error.message() + ".");
  return {};
}

}  // namespace

Result<void> restoreStore(const fs::path& file, const fs::path& backup, const std::string& administrator,
                          const std::string& password) {
  if (!fs::exists(backup)) return fail(backup.string() + " does not exist; name the file of a backup.");
  std::error_code ignored;
  if (fs::equivalent(file, backup, ignored)) return fail(file.string() + " is the store itself; name a backup of it.");
  const auto refused = [&](const Error& why) {
    return fail("The backup " + backup.string() + " was not restored: " + why.message);
  };
  const bool replaces = isWhole(file);
  const Result<std::optional<Restorer>> restorer = replaces ? askReplaced(file, administrator, password) : std::nullopt;
  if (!restorer) return refused(restorer.error());
  const Candidate candidate(file);
  if (auto copied = store::copyFile(backup, candidate.file); !copied) return copied;
  if (auto ok = checkCandidate(candidate.file, *restorer, administrator, password); !ok) return refused(ok.error());
  // Restores recordings first: a file without a row does no harm, but a row without its recording cannot be checked.
  if (auto copied = store::copyRecordings(store::recordingsBeside(backup), store::recordingsBeside(file)); !copied)
    return refused(copied.error());
  return replaces ? writeOver(file, candidate.file) : moveInto(file, candidate.file);
}

}  // namespace insonate
