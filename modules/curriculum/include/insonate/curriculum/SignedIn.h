#pragma once

#include <insonate/curriculum/Person.h>

#include <memory>

namespace insonate {
namespace store {
class Session;
}

/// A signed-in user of a store, on whose behalf data is read and written. Copies are handles of the same session. The
/// session keeps the store open and ends with the last copy. Permissions are read at each call: a user who is disabled,
/// or whose password was reset by others, is refused from then on. Any thread may use it.
class SignedIn {
 public:
  bool isGuest() const;
  /// The user's data at sign-in; all empty for a guest.
  const Person& person() const;
  /// Tells whether the user must first call PeopleStore::changeOwnPassword(); nothing else is allowed until then.
  bool mustChangePassword() const;

  /// Used by the stores of this module.
  explicit SignedIn(std::shared_ptr<store::Session> session);
  const std::shared_ptr<store::Session>& session() const { return session_; }

 private:
  std::shared_ptr<store::Session> session_;
};

}  // namespace insonate
