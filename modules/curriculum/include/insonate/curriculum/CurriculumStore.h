#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace insonate {
namespace store {
class Core;
}

/// Cost of one guess at a password: argon2id by libsodium. `Least` is for tests.
enum class PasswordCost { Usual, Least };

/// Services that a store takes from its surroundings. An empty function or text selects the system's own.
struct StoreServices {
  std::function<std::int64_t()> now_us{};     ///< since 1970, UTC; may jump
  std::function<std::int64_t()> upTime_us{};  ///< since the computer's start; does not jump
  std::string boot{};                         ///< tells one start of the computer from another
  std::string workstation{};                  ///< the computer's name; unique among those that share a server
  PasswordCost passwordCost = PasswordCost::Usual;
  /// Folder where recordings of attempts are kept, made when the first comes; "": FILE.recordings beside the store's
  /// file. A server's store keeps none itself, so each workstation names a folder of its own.
  std::filesystem::path recordings{};
};

struct NewPerson {
  std::string name{};  ///< to sign in, 1..64 letters, digits and . _ - + @, all letters of one script
  std::string fullName{};
  std::string email{};
  Role role = Role::Trainee;
};

/// People, curricula, attempts and forms, kept in a file (SQLite) or on a server (PostgreSQL). Nothing is read or
/// written but through who is signed in, by the classes beside this one: PeopleStore, CohortStore, AttemptStore,
/// PublishedCurricula, FormStore, AuditLog, StoreUpkeep; SiteUpload carries facts to a server.
///
/// Copies are handles of one store. All calls wait for the disk or the server: not for a window's thread. Any thread
/// may call; each has a connection of its own, made when it first asks.
class CurriculumStore {
 public:
  /// `address` is a file, created when missing (its folder must exist), or
  /// postgresql://USER[:PASSWORD]@HOST[:PORT]/DATABASE, the password otherwise from PGPASSWORD or ~/.pgpass. Brings an
  /// older schema up to date, after a backup beside the file. Attempts that a process of this workstation left open
  /// when it died are told abandoned. Fails where the database is damaged, where a newer program made it, where it
  /// cannot be reached or written.
  static Result<CurriculumStore> open(const std::string& address, const StoreServices& services = {});

  /// For people: the file, or the server without the password.
  const std::string& place() const;
  const std::string& workstation() const;
  /// Folder that keeps the recordings of attempts, as ID.attempt; "": none is kept.
  const std::filesystem::path& recordings() const;

  /// False: this is a first run; ask for the administrator.
  Result<bool> hasPeople() const;
  /// Signed in at once. Fails once there is anybody; `first.role` is not looked at.
  Result<SignedIn> createFirstAdministrator(const NewPerson& first, const std::string& password) const;

  /// Fails with one sentence for a wrong name, a wrong password and who is disabled, after the same time. After five
  /// failures for a name, whether it exists or not, it is locked for a while that doubles up to an hour. Takes about
  /// 0.1 s.
  Result<SignedIn> signIn(const std::string& name, const std::string& password) const;
  /// Reads published curricula, and keeps nothing.
  SignedIn guest() const;

 private:
  friend class SiteUpload;
  explicit CurriculumStore(std::shared_ptr<store::Core> core);
  std::shared_ptr<store::Core> core_;
};

}  // namespace insonate
