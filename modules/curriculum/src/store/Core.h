#pragma once

#include "store/LockOut.h"
#include "store/Process.h"
#include "store/sql/Transaction.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace insonate::store {

/// An open store: its address, the clocks, and a connection for each calling thread.
class Core {
 public:
  /// Opens a checked store at the newest schema, and marks attempts of dead processes abandoned.
  static Result<std::shared_ptr<Core>> open(const std::string& address, const StoreServices& services);
  /// Opens a checked store at its present schema, for callers that ask the user before changing it.
  static Result<std::shared_ptr<Core>> reach(const std::string& address, const StoreServices& services);
  /// Migrates to the newest schema and marks the attempts of dead processes as abandoned.
  Result<void> bringUpToDate();
  ~Core();
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  /// Returns the connection of the calling thread; opens a new connection after the connection to the server was lost.
  Result<Connection*> connection();

  /// Begins a transaction on the calling thread's connection. If the connection to the server was lost, connects again.
  Result<std::unique_ptr<Transaction>> begin(Way way);

  const Address& address() const { return address_; }
  const std::string& place() const { return place_; }
  const std::string& workstation() const { return services_.workstation; }
  /// Folder for recordings of attempts; "": none are kept.
  const std::filesystem::path& recordings() const { return recordings_; }
  PasswordCost passwordCost() const { return services_.passwordCost; }
  const Process& process() const { return process_; }
  const std::string& run() const { return run_; }
  std::int64_t now_us() const { return services_.now_us(); }
  Moment moment() const { return {services_.now_us(), services_.upTime_us(), services_.boot}; }

  /// Adds an entry to the audit log, with the present time and workstation; in a writing transaction.
  void audit(Transaction& transaction, const std::string& actor, std::string_view act, const std::string& person,
             const std::string& detail, bool allowed = true) const;

 private:
  Core(Address address, StoreServices services);

  const Address address_;
  const std::string place_;
  const StoreServices services_;
  const std::filesystem::path recordings_;
  const Process process_;
  const std::string run_;    ///< UUID of this opening of the store
  const std::uint64_t key_;  ///< identifies this store among the stores that the program has open
};

/// Runs `work`, which takes a Transaction and returns a Result, in one transaction, which is undone if `work` fails.
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
