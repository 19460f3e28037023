#include "store/Session.h"

#include "store/AuditChain.h"

#include <cstdint>

namespace insonate::store {
namespace {

std::string detailOf(const Request& request, const Verdict& verdict) {
  std::string detail;
  const auto add = [&](const std::string& what, const std::string& value) {
    if (!value.empty()) detail += (detail.empty() ? "" : ", ") + what + forLog(value);
  };
  add("", request.detail);
  if (!request.people.empty()) detail += "people";
  for (const std::string& person : request.people) detail += ' ' + forLog(person);
  add("cohort ", request.cohort);
  add("attempt ", request.attempt);
  if (verdict.learners) add("learners ", std::to_string(*verdict.learners));
  return detail;
}

}  // namespace

Result<void> Session::also(Transaction& transaction, const Request& request) {
  Actor actor{.id = person_.id, .passwordVersion = passwordVersion_, .by = by_};
  const Verdict verdict = decide(transaction, actor, request);
  if (verdict.logged) log(transaction, request, verdict);
  if (verdict.refusal) return tl::unexpected(*verdict.refusal);
  return {};
}

/// Looks at the user's latest entries only, so that the time does not grow with the log. An entry of the future, by a
/// clock that was set back since, does not count.
bool Session::isLoggedAlready(Transaction& transaction, const Request& request, const Verdict& verdict) const {
  constexpr std::int64_t kHour_us = std::int64_t{3600} * 1'000'000;
  constexpr int kLatest = 100;
  if (!request.isLoggedHourly || verdict.refusal) return false;
  const std::int64_t now_us = core_->now_us();
  return transaction.number(
             "SELECT COUNT(*) FROM (SELECT * FROM audit WHERE actor = ? ORDER BY number DESC LIMIT ?) AS latest WHERE "
             "act "
             "= ? AND person = ? AND detail = ? AND allowed = 1 AND time_us > ? AND time_us <= ?",
             person_.id, kLatest, std::string(ruleOf(request.act).words), verdict.person, detailOf(request, verdict),
             now_us - kHour_us, now_us) > 0;
}

void Session::log(Transaction& transaction, const Request& request, const Verdict& verdict) {
  core_->audit(transaction, person_.id, ruleOf(request.act).words, verdict.person, detailOf(request, verdict),
               !verdict.refusal);
}

}  // namespace insonate::store

namespace insonate {

SignedIn::SignedIn(std::shared_ptr<store::Session> session) : session_(std::move(session)) {}

bool SignedIn::isGuest() const {
  return session_->person().id.empty();
}

const Person& SignedIn::person() const {
  return session_->person();
}

bool SignedIn::mustChangePassword() const {
  return session_->mustChangePassword();
}

std::int64_t SignedIn::now_us() const {
  return session_->core().now_us();
}

}  // namespace insonate
