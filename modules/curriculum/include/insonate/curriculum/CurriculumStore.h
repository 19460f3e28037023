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

/// Computing cost of hashing a password (argon2id by libsodium), which slows down guessing. `Minimum`: minimum cost,
/// for tests.
enum class PasswordCost { Default, Minimum };

/// Clocks and names that a CurriculumStore uses. For an empty function or text, the clock or name of the system is
/// used.
struct StoreServices {
  std::function<std::int64_t()> now_us{};     ///< wall-clock time since 1970, UTC; may jump
  std::function<std::int64_t()> upTime_us{};  ///< monotonic time since the computer's start
  std::string boot{};                         ///< boot id: identifies the present run of the operating system
  std::string workstation{};                  ///< name of the computer, unique among the computers that share a server
  PasswordCost passwordCost = PasswordCost::Default;
  /// Folder for the recordings of attempts, created with the first recording; "": FILE.recordings beside the database
  /// file. If the database is on a server, which keeps no recordings, each workstation names a folder of its own.
  std::filesystem::path recordings{};
  /// true: a database file that the user cannot write is opened for reading; see CurriculumStore::isReadOnly().
  bool opensReadOnly = false;
};

/// Data of a person for whom an account is to be created.
struct NewPerson {
  std::string name{};  ///< name for signing in: 1 to 64 letters, digits and . _ - + @, all letters of one script
  std::string fullName{};
  std::string email{};
  Role role = Role::Trainee;
};

/// Database of people, curricula, attempts and forms, in a file (SQLite) or on a server (PostgreSQL). A signed-in user
/// accesses the database through these classes: PeopleStore, CohortStore, AttemptStore, PublishedCurricula, FormStore,
/// AuditLog, StoreUpkeep. SiteUpload exchanges data with a server.
///
/// Copies of an object refer to the same database. All functions wait for the disk or the server: do not call them on
/// the GUI thread. Any other thread may call them; each thread has its own connection, which is made at its first call.
class CurriculumStore {
 public:
  /// Opens a database. `address` is a file, created if missing (its folder must exist), or
  /// postgresql://USER[:PASSWORD]@HOST[:PORT]/DATABASE; without PASSWORD, the password comes from PGPASSWORD or
  /// ~/.pgpass. An older schema is upgraded, after a backup beside the file. Attempts that a crashed process of this
  /// workstation left open are marked abandoned. Fails if the database is damaged, was made by a newer program version,
  /// or cannot be reached or written.
  static Result<CurriculumStore> open(const std::string& address, const StoreServices& services = {});

  /// Returns the name of the database for messages: the file, or the server without the password.
  const std::string& place() const;
  const std::string& workstation() const;
  /// Tells whether the database is a file that the user can only read (StoreServices::opensReadOnly). Everything can
  /// then be read as it was when the file was opened; storing anything fails with a sentence, and accesses are not
  /// logged.
  bool isReadOnly() const;
  /// Returns the folder of the attempts' recordings, which are named ID.attempt; empty if none are kept.
  const std::filesystem::path& recordings() const;

  /// Tells whether there are accounts. False on a first run, in which the user must create the first administrator.
  Result<bool> hasPeople() const;
  /// Creates the first administrator and signs in. Fails if there are people already; `first.role` is ignored.
  Result<SignedIn> createFirstAdministrator(const NewPerson& first, const std::string& password) const;

  /// Signs a user in. A wrong name, a wrong password and a disabled person fail with the same sentence after the same
  /// time. After five failures for a name, whether or not it exists, the name is locked for 30 s; this time doubles
  /// with each further failure, up to an hour. Takes about 0.1 s.
  Result<SignedIn> signIn(const std::string& name, const std::string& password) const;
  /// Signs in with a token of PeopleStore::staySignedIn(). Fails if the token was revoked, the password was changed
  /// since, or the account is disabled.
  Result<SignedIn> signInByToken(const std::string& token) const;
  /// Returns a session without an account. A guest can read published curricula and do nothing else.
  SignedIn guest() const;

 private:
  friend class AuditAnchors;
  friend class BrowserSessions;
  friend class ErasedAttempts;
  friend class RetentionSchedule;
  friend class SiteService;
  friend class SiteUpload;
  friend class VerificationQueue;
  friend class VideoQueue;
  explicit CurriculumStore(std::shared_ptr<store::Core> core);
  std::shared_ptr<store::Core> core_;
};

}  // namespace insonate
