#include "store/Core.h"
#include "store/Migrations.h"
#include "store/PasswordProof.h"
#include "store/StoreChecks.h"
#include "store/sql/FileCopy.h"

#include <insonate/curriculum/StoreUpkeep.h>

#include <unistd.h>

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

/// A database's file and the two that SQLite keeps beside it.
constexpr const char* kParts[] = {"", "-wal", "-shm"};

/// A copy of a backup to check, migrate and put in place; gone when this ends, unless it was moved.
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

/// Whether its pages are whole, its log holds together, and an administrator of it asks; leaves an entry in it.
Result<void> checkCandidate(const fs::path& file, const std::string& administrator, const std::string& password) {
  const auto core = Core::open(file.string(), {});
  if (!core) return tl::unexpected(core.error());
  const auto known = store::provePassword(**core, administrator, password);
  if (!known) return tl::unexpected(known.error());
  if (known->person.role != Role::Administrator)
    return fail(administrator + " is no administrator of the backup; one of them restores it.");
  return inTransaction(**core, Way::Write, [&](Transaction& transaction) -> Result<void> {
    if (auto ok = store::verifyAll(transaction); !ok) return ok;
    (*core)->audit(transaction, known->person.id, "restore backup", "", "");
    return {};
  });
}

bool isWhole(const fs::path& file) {
  if (!fs::exists(file)) return false;
  const auto connection = Connection::open(*Address::parse(file.string()));
  return connection && store::checkPages(**connection);
}

/// Where the file is a database that others may have open, it is written over as one of their changes.
Result<void> writeOver(const fs::path& file, const fs::path& candidate) {
  const auto to = Connection::open(*Address::parse(file.string()));
  if (!to) return tl::unexpected(to.error());
  if (auto kept = store::copyToFile(**to, with(file, ".before-restore")); !kept) return kept;
  const auto from = Connection::open(*Address::parse(candidate.string()));
  if (!from) return tl::unexpected(from.error());
  return store::copyInto(**from, **to);
}

/// Where it is missing or damaged.
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
  const Candidate candidate(file);
  if (auto copied = store::copyFile(backup, candidate.file); !copied) return copied;
  if (auto ok = checkCandidate(candidate.file, administrator, password); !ok)
    return fail("The backup " + backup.string() + " was not restored: " + ok.error().message);
  return isWhole(file) ? writeOver(file, candidate.file) : moveInto(file, candidate.file);
}

}  // namespace insonate
