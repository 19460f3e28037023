#include "store/sql/FileCopy.h"

#include "store/sql/PrivateFile.h"

#include <insonate/core/AtomicFile.h>

#include <sqlite3.h>

#include <chrono>
#include <memory>
#include <thread>

namespace insonate::store {
namespace {

constexpr int kPagesAStep = 1000, kMaxWaits = 500;

/// Another writer between two steps makes SQLite start the copy again; it gives up after 10 s without progress.
int copyPages(sqlite3_backup* backup, int pagesAStep) {
  int waits = 0;
  for (;;) {
    const int code = sqlite3_backup_step(backup, pagesAStep);
    if (code == SQLITE_OK) continue;
    if ((code != SQLITE_BUSY && code != SQLITE_LOCKED) || ++waits > kMaxWaits) return code;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

Result<void> copy(sqlite3* from, sqlite3* to, int pagesAStep, const std::string& what) {
  sqlite3_backup* const backup = sqlite3_backup_init(to, "main", from, "main");
  const int code = backup ? copyPages(backup, pagesAStep) : sqlite3_errcode(to);
  sqlite3_backup_finish(backup);
  if (code == SQLITE_DONE) return {};
  return fail("Could not copy " + what + ": " + sqlite3_errstr(code) + ". Check the disk and try again.");
}

struct Closing {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
using Database = std::unique_ptr<sqlite3, Closing>;

Result<Database> opened(const std::filesystem::path& file, int flags) {
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &database, flags, nullptr);
  Database owned(database);
  if (code != SQLITE_OK) return fail("Could not open " + file.string() + ": " + sqlite3_errstr(code) + ".");
  return owned;
}

Result<void> writeCopy(sqlite3* from, const std::string& what, const std::filesystem::path& file) {
  return writeAtomically(file, [&](const std::filesystem::path& beside) -> Result<void> {
    makePrivate(beside);
    const auto to = opened(beside, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    if (!to) return tl::unexpected(to.error());
    if (auto copied = copy(from, to->get(), kPagesAStep, what + " to " + file.string()); !copied) return copied;
    // The copy of a store in use would need additional files beside it.
    if (sqlite3_exec(to->get(), "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr) != SQLITE_OK)
      return fail("Could not write " + file.string() + ": " + sqlite3_errmsg(to->get()) + ".");
    return {};
  });
}

}  // namespace

Result<void> copyToFile(Connection& from, const std::filesystem::path& file) {
  return writeCopy(from.handle(), from.place(), file);
}

Result<void> copyFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  const auto database = opened(from, SQLITE_OPEN_READONLY);
  if (!database) return tl::unexpected(database.error());
  return writeCopy(database->get(), from.string(), to);
}

Result<void> copyInto(Connection& from, Connection& to) {
  // Renames in one step, so that no process sees an incomplete file.
  return copy(from.handle(), to.handle(), -1, from.place() + " to " + to.place());
}

}  // namespace insonate::store
