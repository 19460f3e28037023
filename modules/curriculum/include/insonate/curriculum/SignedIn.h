#pragma once

#include <insonate/curriculum/Person.h>

#include <memory>

namespace insonate {
namespace store {
class Session;
}

/// Someone at a store; all reading and writing is theirs. Copies are handles of one session, which keeps the store open
/// and ends with the last copy. What they may do is looked up at each call: who is disabled, or whose password was set
/// anew by others, is refused from then on. Any thread.
class SignedIn {
 public:
  bool isGuest() const;
  /// As they were when they signed in; of a guest all empty.
  const Person& person() const;
  /// Nothing but PeopleStore::changeOwnPassword() is allowed until they have.
  bool mustChangePassword() const;

  /// For the stores of this module.
  explicit SignedIn(std::shared_ptr<store::Session> session);
  const std::shared_ptr<store::Session>& session() const { return session_; }

 private:
  std::shared_ptr<store::Session> session_;
};

}  // namespace insonate
