#pragma once

#include <insonate/curriculum/Person.h>

#include <cstdint>
#include <memory>

namespace insonate {
namespace store {
class Session;
}

/// Session of a user who has signed in to the database of people and attempts. The database is read and written with
/// the permissions of this user. Copies refer to the same session; the session keeps the database open and ends with
/// the last copy. Permissions are checked at each call: after a user was disabled, or another person reset the user's
/// password, all calls fail. May be used on any thread.
class SignedIn {
 public:
  bool isGuest() const;
  /// Returns the user's data at sign-in; all empty for a guest.
  const Person& person() const;
  /// Tells whether the user must first call PeopleStore::changeOwnPassword(); nothing else is allowed until then.
  bool mustChangePassword() const;
  /// Returns the time of the database's clock (StoreServices::now_us), since 1970, UTC.
  std::int64_t now_us() const;

  /// Used only by the classes of this module, such as AttemptStore.
  explicit SignedIn(std::shared_ptr<store::Session> session);
  const std::shared_ptr<store::Session>& session() const { return session_; }

 private:
  std::shared_ptr<store::Session> session_;
};

}  // namespace insonate
