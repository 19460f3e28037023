#include "store/Core.h"
#include "store/LockOut.h"
#include "store/PasswordProof.h"
#include "store/Passwords.h"
#include "store/PeopleRows.h"
#include "store/Session.h"
#include "store/Texts.h"

#include <insonate/curriculum/BrowserSessions.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

namespace insonate {
namespace {

constexpr std::int64_t kMinute_us = std::int64_t{60} * 1'000'000;

/// A clock that is set back must not keep a session for longer: what began in the future has ended, too.
bool hasEnded(std::int64_t begun_us, std::int64_t used_us, std::int64_t now_us) {
  return now_us < begun_us - kMinute_us || now_us - begun_us > BrowserSessions::kLongest_us ||
         now_us - used_us > BrowserSessions::kLongestIdle_us;
}

/// The secret says how its session was begun: the database has the hash of the whole secret, so that a changed prefix
/// belongs to no session.
constexpr std::string_view kByProvider = "openid-";
constexpr const char* kNoRandomNumbers = "There are no random numbers for a session; restart the server.";

void insertSession(store::Transaction& transaction, std::int64_t now_us, const std::string& secret,
                   const std::string& person, std::int64_t passwordVersion) {
  transaction.run("DELETE FROM browser_sessions WHERE begun_us < ? OR used_us < ?",
                  now_us - BrowserSessions::kLongest_us, now_us - BrowserSessions::kLongestIdle_us);
  transaction.run("INSERT INTO browser_sessions VALUES (?, ?, ?, ?, ?)", store::sha256(secret), person, passwordVersion,
                  now_us, now_us);
}

/// Names the count of an address for sign-ins by a provider, apart from its wrong passwords: an outage of the provider
/// must not lock passwords, which are then the only way in.
std::string providerCountOf(const std::string& address) {
  return "openid " + address;
}

/// Key by which the address of a provider is compared: the case of A to Z does not count. A wider folding, as in
/// nameKey(), would give the account to the owner of another mailbox.
std::string emailKey(std::string email) {
  for (char& one : email)
    if (one >= 'A' && one <= 'Z') one = static_cast<char>(one - 'A' + 'a');
  return email;
}

struct ProvenAccount {
  Person person{};
  std::int64_t passwordVersion = 0;
};

std::vector<ProvenAccount> accountsWith(store::Transaction& transaction, const std::string& email) {
  std::vector<ProvenAccount> found;
  const std::string key = emailKey(email);
  for (const store::Row& row :
       transaction.rows("SELECT " INSONATE_PERSON_COLUMNS ", version FROM people JOIN credentials ON person = id "
                        "WHERE email <> ''"))
    if (ProvenAccount account{store::personOf(row), row.number(6)}; emailKey(account.person.email) == key)
      found.push_back(std::move(account));
  return found;
}

/// Keeps the account that may sign in, or returns the reason why there is none.
std::optional<Error> keepOnlyEnabled(std::vector<ProvenAccount>& accounts) {
  if (accounts.empty())
    return Error{
        "No account has the e-mail address that the hospital sent. Ask the administrator of this server to enter this "
        "address in your account."};
  std::erase_if(accounts, [](const ProvenAccount& account) { return account.person.disabled; });
  if (accounts.empty())
    return Error{"Your account is disabled. Ask the administrator of this server to enable the account."};
  if (accounts.size() > 1)
    return Error{
        "Several accounts have your e-mail address. Ask the administrator of this server to leave the address in one "
        "account only."};
  return std::nullopt;
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
  if (secret.empty()) return fail(kNoRandomNumbers);
  store::Core& core = *store_.core_;
  return inTransaction(core, store::Way::Write, [&](store::Transaction& transaction) -> Result<std::string> {
    insertSession(transaction, core.now_us(), secret, by.person().id, by.session()->passwordVersion());
    return secret;
  });
}

Result<void> BrowserSessions::countSignInAttempt(const std::string& address) const {
  if (address.empty()) return {};
  store::Core& core = *store_.core_;
  const auto wait_s =
      inTransaction(core, store::Way::Write, [&](store::Transaction& transaction) -> Result<std::int64_t> {
        return store::secondsAddressLockedAfterTry(transaction, providerCountOf(address), core.moment());
      });
  if (!wait_s) return tl::unexpected(wait_s.error());
  if (*wait_s == 0) return {};
  return fail("There were too many failed sign-ins from this network address. Try again in " + std::to_string(*wait_s) +
              " s.");
}

Result<std::string> BrowserSessions::begin(const VerifiedEmail& email, const std::string& address) const {
  const std::string random = store::randomToken();
  if (random.empty()) return fail(kNoRandomNumbers);
  const std::string secret = std::string(kByProvider) + random;
  store::Core& core = *store_.core_;
  std::optional<Error> refusal;
  const auto begun = inTransaction(core, store::Way::Write, [&](store::Transaction& transaction) -> Result<void> {
    std::vector<ProvenAccount> accounts = accountsWith(transaction, email.text());
    const std::string first = accounts.empty() ? "" : accounts.front().person.id;
    refusal = keepOnlyEnabled(accounts);
    // A refusal stays in the log, so the transaction succeeds.
    if (refusal) {
      core.audit(transaction, "", "sign in", first, "OpenID", false);
      return {};
    }
    const ProvenAccount& account = accounts.front();
    if (!address.empty()) store::discountTry(transaction, providerCountOf(address));
    core.audit(transaction, account.person.id, "sign in", account.person.id, "OpenID");
    insertSession(transaction, core.now_us(), secret, account.person.id, account.passwordVersion);
    return {};
  });
  if (!begun) return tl::unexpected(begun.error());
  if (refusal) return tl::unexpected(*refusal);
  return secret;
}

bool BrowserSessions::isByProvider(const std::string& secret) {
  return secret.starts_with(kByProvider);
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
    const store::SignInBy way = isByProvider(secret) ? store::SignInBy::Provider : store::SignInBy::Password;
    return SignedIn(
        std::make_shared<store::Session>(store_.core_, store::personOf(*row), row->number(6), row->truth(7), way));
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

Result<void> BrowserSessions::keepAfterPasswordChange(const std::string& secret) const {
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
