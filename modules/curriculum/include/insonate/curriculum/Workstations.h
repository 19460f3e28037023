#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// A workstation that may exchange data with the server of a database (SiteService).
struct Workstation {
  std::string name{};     ///< name, as in AttemptFacts::workstation
  std::string addedBy{};  ///< full name of the person who added the workstation, or sign-in name if there is no full
                          ///< name
  std::int64_t added_us = 0;
  std::optional<std::int64_t> seen_us{};  ///< time of the workstation's last request; empty: none yet
  std::optional<std::int64_t> revoked_us{};

  bool operator==(const Workstation&) const = default;
};

/// Access to the workstations of a server's database; for administrators. A workstation has a token instead of a
/// password of the database. The database keeps the token's hash only.
class Workstations {
 public:
  explicit Workstations(SignedIn by) : by_(std::move(by)) {}

  /// Adds a workstation and returns its token, 64 hexadecimal digits, which cannot be shown again. A workstation of
  /// this name that was revoked gets a new token. `name`: 1 to 64 characters; fails if a workstation of this name is in
  /// use.
  Result<std::string> add(const std::string& name) const;
  /// Ends the access of a workstation at once; data that the workstation has sent stays.
  Result<void> revoke(const std::string& name) const;
  /// Returns all workstations, sorted by name.
  Result<std::vector<Workstation>> list() const;

 private:
  SignedIn by_;
};

}  // namespace insonate
