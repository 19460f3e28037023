#pragma once

#include "store/LockOut.h"
#include "store/Process.h"
#include "store/ReadOnlyCopy.h"
#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace insonate::store {

/// An open curriculum database: its address, the clocks, and a connection for each calling thread.
class Core {
 public:
  /// Opens a database, checks its integrity, upgrades it to the newest schema, and marks attempts of crashed processes
  /// as abandoned.
  static Result<std::shared_ptr<Core>> open(const std::string& address, const StoreServices& services);
  /// Opens a database and checks its integrity, without upgrading its schema; for callers that first check whether the
  /// user may do that.
  static Result<std::shared_ptr<Core>> reach(const std::string& address, const StoreServices& services);
  /// Upgrades the database to the newest schema, and marks attempts of crashed processes as abandoned.
  Result<void> bringUpToDate();
  ~Core();
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  /// Returns the calling thread's connection to the database; connects again if the connection to the server was lost.
  /// Fails if the file was deleted, replaced or emptied after it was opened.
  Result<Connection*> connection();

  /// Begins a transaction on the calling thread's connection; connects again if the connection to the server was lost.
  Result<std::unique_ptr<Transaction>> begin(Way way);

  /// Tells whether the database is a copy of a file that the user can only read; begin(Way::Write) then fails.
  bool isReadOnly() const { return copy_ && isUpToDate_; }
  const Address& address() const { return address_; }
  const std::string& place() const { return place_; }
  const std::string& workstation() const { return services_.workstation; }
  /// Returns the folder for recordings of attempts; "": none are kept.
  const std::filesystem::path& recordings() const { return recordings_; }
  PasswordCost passwordCost() const { return services_.passwordCost; }
  const Process& process() const { return process_; }
  const std::string& run() const { return run_; }
  std::int64_t now_us() const { return services_.now_us(); }
  Moment moment() const { return {services_.now_us(), services_.upTime_us(), services_.boot}; }

  /// Adds an entry to the audit log, with the present time and workstation. `transaction` must be one for writing.
  void audit(Transaction& transaction, const std::string& actor, std::string_view act, const std::string& person,
             const std::string& detail, bool allowed = true) const;

 private:
  Core(Address address, StoreServices services, std::unique_ptr<ReadOnlyCopy> copy);
  /// Fails if the file was deleted, replaced or emptied after it was opened.
  Result<void> checkFile() const;

  const std::unique_ptr<ReadOnlyCopy> copy_;
  const Address address_;
  const std::string place_;
  const StoreServices services_;
  const std::filesystem::path recordings_;
  const Process process_;
  const std::string run_;         ///< UUID of this opened database, new for each call of open() or reach()
  const std::uint64_t key_;       ///< identifies this database among those that the program has open
  std::uint64_t fileNumber_ = 0;  ///< inode of the file when it was opened; 0: not opened yet, or a server
  bool isUpToDate_ = false;       ///< true: bringUpToDate() has upgraded the database
};

/// Runs `work`, which takes a Transaction and returns a Result, in one transaction; if `work` fails, all changes are
/// undone.
template <class Work>
auto inTransaction(Core& core, Way way, const Work& work) -> decltype(work(std::declval<Transaction&>())) {
  const auto transaction = core.begin(way);
  if (!transaction) return tl::unexpected(transaction.error());
  auto result = work(**transaction);
  // A failed statement returns no rows; this empty result must not be taken for an answer.
  if ((*transaction)->error()) return tl::unexpected(*(*transaction)->error());
  if (!result) return result;
  if (auto done = (*transaction)->commit(); !done) return tl::unexpected(done.error());
  return result;
}

}  // namespace insonate::store
