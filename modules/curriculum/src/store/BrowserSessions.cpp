#include "store/Core.h"
#include "store/PasswordProof.h"
#include "store/Passwords.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/BrowserSessions.h>

namespace insonate {
namespace {

constexpr std::int64_t kMinute_us = std::int64_t{60} * 1'000'000;

/// A clock that is set back must not keep a session for longer: what began in the future has ended, too.
bool hasEnded(std::int64_t begun_us, std::int64_t used_us, std::int64_t now_us) {
  return now_us < begun_us - kMinute_us || now_us - begun_us > BrowserSessions::kLongest_us ||
         now_us - used_us > BrowserSessions::kLongestIdle_us;
}

}  // namespace

Result<SignedIn> BrowserSessions::signIn(const std::string& name, const std::string& password,
                                         const std::string& address) const {
  const auto known = store::provePassword(*store_.core_, name, password, address);
  if (!known) return tl::unexpected(known.error());
  return SignedIn(
      std::make_shared<store::Session>(store_.core_, known->person, known->passwordVersion, known->mustChange));
}

Result<std::string> BrowserSessions::begin(const SignedIn& by) const {
  const std::string secret = store::randomToken();
  if (secret.empty()) return fail("There are no random numbers for a session; restart the server.");
  store::Core& core = *store_.core_;
  return inTransaction(core, store::Way::Write, [&](store::Transaction& transaction) -> Result<std::string> {
    const std::int64_t now_us = core.now_us();
    transaction.run("DELETE FROM browser_sessions WHERE begun_us < ? OR used_us < ?", now_us - kLongest_us,
                    now_us - kLongestIdle_us);
    transaction.run("INSERT INTO browser_sessions VALUES (?, ?, ?, ?, ?)", store::sha256(secret), by.person().id,
                    by.session()->passwordVersion(), now_us, now_us);
    return secret;
  });
}

Result<std::optional<SignedIn>> BrowserSessions::resume(const std::string& secret, bool isByUser) const {
  using Outcome = Result<std::optional<SignedIn>>;
  store::Core& core = *store_.core_;
  const std::string hash = store::sha256(secret);
  const std::int64_t now_us = core.now_us();
  bool isOutdated = false;
  auto found = inTransaction(core, store::Way::Read, [&](store::Transaction& transaction) -> Outcome {
    const auto row = transaction.row(
        "SELECT " INSONATE_PERSON_COLUMNS
        ", credentials.version, must_change, begun_us, used_us FROM browser_sessions "
        "JOIN people ON people.id = browser_sessions.person JOIN credentials ON credentials.person = people.id "
        "WHERE hash = ? AND disabled = 0 AND credentials.version = browser_sessions.version",
        hash);
    if (!row || hasEnded(row->number(8), row->number(9), now_us)) return std::nullopt;
    isOutdated = now_us - row->number(9) > kMinute_us;
    return SignedIn(
        std::make_shared<store::Session>(store_.core_, store::personOf(*row), row->number(6), row->truth(7)));
  });
  if (!found || !*found || !isOutdated || !isByUser) return found;
  const auto noted = inTransaction(core, store::Way::Write, [&](store::Transaction& transaction) -> Result<void> {
    transaction.run("UPDATE browser_sessions SET used_us = ? WHERE hash = ?", now_us, hash);
    return {};
  });
  if (!noted) return tl::unexpected(noted.error());
  return found;
}

Result<int> BrowserSessions::count() const {
  store::Core& core = *store_.core_;
  return inTransaction(core, store::Way::Read, [&](store::Transaction& transaction) -> Result<int> {
    return static_cast<int>(
        transaction.number("SELECT COUNT(*) FROM browser_sessions WHERE begun_us >= ? AND used_us >= ?",
                           core.now_us() - kLongest_us, core.now_us() - kLongestIdle_us));
  });
}

Result<void> BrowserSessions::end(const std::string& secret) const {
  return inTransaction(*store_.core_, store::Way::Write, [&](store::Transaction& transaction) -> Result<void> {
    transaction.run("DELETE FROM browser_sessions WHERE hash = ?", store::sha256(secret));
    return {};
  });
}

Result<void> BrowserSessions::continueWithNewPassword(const std::string& secret) const {
  return inTransaction(*store_.core_, store::Way::Write, [&](store::Transaction& transaction) -> Result<void> {
    const std::string hash = store::sha256(secret);
    transaction.run(
        "DELETE FROM browser_sessions WHERE hash <> ? AND person IN "
        "(SELECT person FROM browser_sessions WHERE hash = ?)",
        hash, hash);
    transaction.run(
        "UPDATE browser_sessions SET version = (SELECT version FROM credentials WHERE credentials.person = "
        "browser_sessions.person) WHERE hash = ?",
        hash);
    return {};
  });
}

}  // namespace insonate
