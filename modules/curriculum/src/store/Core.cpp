#include "store/Core.h"

#include "store/AuditChain.h"
#include "store/CrashedAttempts.h"
#include "store/FailureNotes.h"
#include "store/Migrations.h"
#include "store/Seals.h"
#include "store/StoreChecks.h"
#include "store/StoredRecordings.h"
#include "store/Texts.h"

#include <sodium.h>
#include <sys/stat.h>

#include <QtCore/QSysInfo>
#include <atomic>
#include <chrono>
#include <ctime>
#include <map>
#include <optional>

namespace insonate::store {
namespace {

std::uint64_t freshKey() {
  static std::atomic<std::uint64_t> counter{0};
  return counter++;
}

/// Connections of this thread, by the key of their store. Connections of other threads end with their thread.
std::map<std::uint64_t, std::unique_ptr<Connection>>& connectionsOfThread() {
  thread_local std::map<std::uint64_t, std::unique_ptr<Connection>> connections;
  return connections;
}

std::int64_t systemNow_us() {
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

/// This clock also runs while the computer sleeps.
std::int64_t systemUpTime_us() {
  timespec time{};
  ::clock_gettime(CLOCK_BOOTTIME, &time);
  return std::int64_t{time.tv_sec} * 1'000'000 + time.tv_nsec / 1000;
}

std::optional<struct stat> stateOf(const std::string& file) {
  struct stat state {};
  return ::stat(file.c_str(), &state) == 0 ? std::optional(state) : std::nullopt;
}

StoreServices completed(StoreServices services, const Process& process) {
  if (!services.now_us) services.now_us = systemNow_us;
  if (!services.upTime_us) services.upTime_us = systemUpTime_us;
  if (services.boot.empty()) services.boot = process.boot;
  if (services.workstation.empty()) services.workstation = QSysInfo::machineHostName().toStdString();
  return services;
}

}  // namespace

Core::Core(Address address, StoreServices services, std::unique_ptr<ReadOnlyCopy> copy)
    : copy_(std::move(copy)),
      address_(std::move(address)),
      place_(address_.place()),
      services_(completed(std::move(services), Process::current())),
      recordings_(recordingsFolder(address_, services_.recordings)),
      process_(Process::current()),
      run_(freshUuid()),
      key_(freshKey()) {}

Core::~Core() {
  connectionsOfThread().erase(key_);
}

Result<std::shared_ptr<Core>> Core::reach(const std::string& address, const StoreServices& services) {
  if (::sodium_init() < 0) return fail("libsodium finds no source of random numbers; passwords cannot be stored.");
  auto parsed = Address::parse(address);
  if (!parsed) return tl::unexpected(parsed.error());
  std::unique_ptr<ReadOnlyCopy> copy;
  if (services.opensReadOnly && !parsed->isServer && isReadOnlyFile(parsed->file.toStdString())) {
    auto made = ReadOnlyCopy::make(parsed->file.toStdString());
    if (!made) return tl::unexpected(made.error());
    copy = std::move(*made);
    parsed->copyOf = std::exchange(parsed->file, QString::fromStdString(copy->file().string()));
  }
  std::shared_ptr<Core> core(new Core(std::move(*parsed), services, std::move(copy)));
  if (auto ok = checkTitle("The workstation's name", core->workstation()); !ok) return tl::unexpected(ok.error());
  const auto connection = core->connection();
  if (!connection) return tl::unexpected(connection.error());
  if (!core->address_.isServer && !core->copy_)
    if (const auto file = stateOf(core->place_)) core->fileNumber_ = file->st_ino;
  if (auto ok = checkPages(**connection); !ok) return tl::unexpected(ok.error());
  if (auto ok = refuseForeign(**connection); !ok) return tl::unexpected(ok.error());
  return core;
}

Result<void> Core::bringUpToDate() {
  const auto own = connection();
  if (!own) return tl::unexpected(own.error());
  if (auto ok = migrate(**own, address_, now_us()); !ok) return ok;
  if (auto ok = storeSecret(*this); !ok) return ok;
  if (auto ok = abandonCrashed(*this); !ok) return ok;
  isUpToDate_ = true;
  return {};
}

Result<std::shared_ptr<Core>> Core::open(const std::string& address, const StoreServices& services) {
  auto core = reach(address, services);
  if (!core) return core;
  if (auto ok = (*core)->bringUpToDate(); !ok) return tl::unexpected(ok.error());
  return core;
}

/// SQLite itself would go on to read and write a deleted file. It would damage a file that has taken its place: the log
/// (-wal) of the former one is still beside it.
Result<void> Core::checkFile() const {
  if (fileNumber_ == 0) return {};
  const auto file = stateOf(place_);
  if (file && file->st_ino == fileNumber_ && file->st_size > 0) return {};
  return fail(place_ +
              (!file                         ? " was deleted"
               : file->st_ino != fileNumber_ ? " was replaced"
                                             : " was emptied") +
              " while it was in use. Nothing was changed; end the program, restore a backup if there is no whole file, "
              "and start the program again.");
}

Result<Connection*> Core::connection() {
  std::unique_ptr<Connection>& own = connectionsOfThread()[key_];
  if (own && own->isLost()) own.reset();
  if (auto ok = checkFile(); !ok) return tl::unexpected(ok.error());
  if (!own) {
    auto opened = Connection::open(address_);
    if (!opened) return tl::unexpected(opened.error());
    own = std::move(*opened);
  }
  return own.get();
}

Result<std::unique_ptr<Transaction>> Core::begin(Way way) {
  if (way == Way::Write && isReadOnly())
    return fail(place_ +
                " can only be read, so nothing can be stored: you cannot write the file or its folder. Change their "
                "permissions, or ask the person who set up the database.");
  for (bool isFirst = true;; isFirst = false) {
    const auto own = connection();
    if (!own) {
      noteDatabaseFailure(own.error());
      return tl::unexpected(own.error());
    }
    auto transaction = std::make_unique<Transaction>(**own, way);
    if (!transaction->error()) return transaction;
    if (isFirst && (*own)->isLost()) continue;
    noteDatabaseFailure(*transaction->error());
    return tl::unexpected(*transaction->error());
  }
}

void Core::audit(Transaction& transaction, const std::string& actor, std::string_view act, const std::string& person,
                 const std::string& detail, bool allowed) const {
  appendAudit(transaction, {.time_us = now_us(),
                            .actor = actor,
                            .workstation = workstation(),
                            .act = std::string(act),
                            .person = forLog(person),
                            // Normalized as the database returns it; otherwise its hash would not match.
                            .detail = bound(detail).toString().toStdString(),
                            .allowed = allowed});
}

}  // namespace insonate::store
