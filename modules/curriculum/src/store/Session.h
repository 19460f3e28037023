#pragma once

#include "store/Access.h"
#include "store/Core.h"

#include <insonate/curriculum/SignedIn.h>

#include <atomic>
#include <memory>
#include <optional>

namespace insonate::store {

/// Session of a signed-in user or guest. All accesses to the database by the module's public classes go through read()
/// and write(), which check the permission and log the access.
class Session {
 public:
  /// `mustChange`: another person set the present password.
  Session(std::shared_ptr<Core> core, Person person, std::int64_t passwordVersion, bool mustChange,
          SignInBy by = SignInBy::Password)
      : core_(std::move(core)),
        person_(std::move(person)),
        by_(by),
        passwordVersion_(passwordVersion),
        mustChange_(mustChange && by == SignInBy::Password) {}

  Core& core() const { return *core_; }
  const Person& person() const { return person_; }
  bool mustChangePassword() const { return mustChange_; }
  /// Number of the password with which the session was opened.
  std::int64_t passwordVersion() const { return passwordVersion_; }
  /// Continues the session after the user has chosen a new password. `version`: number of the new password.
  void hasPassword(std::int64_t version) {
    passwordVersion_ = version;
    mustChange_ = false;
  }

  /// Checks the permission for `request` and runs `work` with a Transaction and the present Actor; `work` returns a
  /// Result. Log entries are on the disk before the result is returned.
  template <class Work>
  auto read(const Request& request, const Work& work) {
    auto outcome = attempt(Way::Read, request, work);
    if (!outcome) outcome = attempt(Way::Log, request, work);
    return *std::move(outcome);
  }
  template <class Work>
  auto write(const Request& request, const Work& work) {
    return *attempt(Way::Write, request, work);
  }
  /// Checks and logs a further request within the transaction of a write().
  Result<void> also(Transaction& transaction, const Request& request);

 private:
  /// Tries a request in a transaction. Empty if the access must be logged but `way` is Read: a transaction for writing
  /// is needed.
  template <class Work>
  auto attempt(Way way, const Request& request, const Work& work) {
    using Outcome = decltype(work(std::declval<Transaction&>(), std::declval<const Actor&>()));
    std::optional<Outcome> outcome;
    const Result<void> done = inTransaction(*core_, way, [&](Transaction& transaction) -> Result<void> {
      Actor actor{.id = person_.id, .passwordVersion = passwordVersion_, .by = by_};
      Verdict verdict = decide(transaction, actor, request);
      if (verdict.logged && isLoggedAlready(transaction, request, verdict)) verdict.logged = false;
      if (verdict.logged && way == Way::Read) return {};
      if (verdict.logged) log(transaction, request, verdict);
      // A refusal stays in the log; changes of failed work are undone.
      if (verdict.refusal) {
        outcome.emplace(tl::unexpected(*verdict.refusal));
        return {};
      }
      outcome.emplace(work(transaction, actor));
      if (!*outcome) return tl::unexpected(outcome->error());
      return {};
    });
    if (!done) outcome.emplace(tl::unexpected(done.error()));
    return outcome;
  }

  bool isLoggedAlready(Transaction& transaction, const Request& request, const Verdict& verdict) const;
  void log(Transaction& transaction, const Request& request, const Verdict& verdict);

  const std::shared_ptr<Core> core_;
  const Person person_;
  const SignInBy by_;
  std::atomic<std::int64_t> passwordVersion_;
  std::atomic<bool> mustChange_;
};

}  // namespace insonate::store
