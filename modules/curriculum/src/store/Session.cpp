#include "store/Session.h"

#include "store/AuditChain.h"

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
