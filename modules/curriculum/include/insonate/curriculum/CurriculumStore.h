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

/// Cost of one password guess: argon2id by libsodium. `Least` is for tests.
enum class PasswordCost { Usual, Least };

/// Services that a store takes from its surroundings. An empty function or text selects the system's.
struct StoreServices {
  std::function<std::int64_t()> now_us{};     ///< since 1970, UTC; may jump
  std::function<std::int64_t()> upTime_us{};  ///< since the computer's start; does not jump
  std::string boot{};                         ///< identifies the present start of the computer
  std::string workstation{};                  ///< the computer's name; unique among those that share a server
  PasswordCost passwordCost = PasswordCost::Usual;
  /// Folder where recordings of attempts are kept, made when the first recording is stored; "": FILE.recordings beside
  /// the store's file. A server's store keeps none itself, so each workstation names a folder of its own.
  std::filesystem::path recordings{};
};

struct NewPerson {
  std::string name{};  ///< name for signing in: 1..64 letters, digits and . _ - + @, all letters of one script
  std::string fullName{};
  std::string email{};
  Role role = Role::Trainee;
};

/// People, curricula, attempts and forms in a file (SQLite) or on a server (PostgreSQL). All access is on behalf of a
/// signed-in user, through these classes: PeopleStore, CohortStore, AttemptStore, PublishedCurricula, FormStore,
/// AuditLog, StoreUpkeep; SiteUpload carries facts to a server.
///
/// Copies are handles of the same store. All calls wait for the disk or the server: do not call them from a window's
/// thread. Any thread may call; each thread has its own connection, made at its first call.
class CurriculumStore {
 public:
  /// Opens a store. `address` is a file, created if missing (its folder must exist), or
  /// postgresql://USER[:PASSWORD]@HOST[:PORT]/DATABASE; without PASSWORD, the password comes from PGPASSWORD or
  /// ~/.pgpass. Upgrades an older schema, after a backup beside the file. Attempts that a crashed process of this
  /// workstation left open are marked abandoned. Fails if the database is damaged, was made by a newer program, or
  /// cannot be reached or written.
  static Result<CurriculumStore> open(const std::string& address, const StoreServices& services = {});

  /// Name of the store for messages: the file, or the server without the password.
  const std::string& place() const;
  const std::string& workstation() const;
  /// Folder of the attempts' recordings, which are named ID.attempt; empty if none are kept.
  const std::filesystem::path& recordings() const;

  /// Tells whether there are accounts. False on a first run, in which the user must create the first administrator.
  Result<bool> hasPeople() const;
  /// Creates the first administrator and signs in. Fails if there are people already; `first.role` is ignored.
  Result<SignedIn> createFirstAdministrator(const NewPerson& first, const std::string& password) const;

  /// Signs in. A wrong name, a wrong password and a disabled person fail with the same sentence after the same time.
  /// After five failures for a name, existing or not, the name is locked for a while that doubles up to an hour. Takes
  /// about 0.1 s.
  Result<SignedIn> signIn(const std::string& name, const std::string& password) const;
  /// Signs in with a token of PeopleStore::staySignedIn(). Fails if the token was revoked, the password was changed
  /// since, or the account is disabled.
  Result<SignedIn> signInByToken(const std::string& token) const;
  /// Returns a guest, who can only read published curricula. Stores nothing.
  SignedIn guest() const;

 private:
  friend class SiteUpload;
  explicit CurriculumStore(std::shared_ptr<store::Core> core);
  std::shared_ptr<store::Core> core_;
};

}  // namespace insonate
