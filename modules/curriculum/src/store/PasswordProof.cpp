#include "store/PasswordProof.h"

#include "store/LockOut.h"
#include "store/Passwords.h"
#include "store/PeopleRows.h"
#include "store/Texts.h"

#include <QtCore/QString>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <set>

namespace insonate::store {
namespace {

constexpr const char* kWrong = "The name or the password is wrong, or the account is disabled.";

std::optional<Known> findByName(Transaction& transaction, const std::string& name) {
  const auto row = transaction.row("SELECT " INSONATE_PERSON_COLUMNS
                                   ", password, version, must_change FROM people JOIN credentials ON person = id "
                                   "WHERE name_key = ?",
                                   nameKey(name));
  if (!row) return std::nullopt;
  return Known{personOf(*row), row->text(6), row->number(7), row->truth(8)};
}

/// Lets this program check one password of a name at a time. Simultaneous guesses are thus counted one after the other,
/// and simultaneous sign-ins with the right password are not taken for guesses.
class Turn {
 public:
  explicit Turn(std::string name) : name_(std::move(name)) {
    std::unique_lock lock(mutex_);
    free_.wait(lock, [this] { return busy_.insert(name_).second; });
  }
  ~Turn() {
    {
      const std::lock_guard lock(mutex_);
      busy_.erase(name_);
    }
    free_.notify_all();
  }
  Turn(const Turn&) = delete;
  Turn& operator=(const Turn&) = delete;

 private:
  static inline std::mutex mutex_;
  static inline std::condition_variable free_;
  static inline std::set<std::string> busy_;
  const std::string name_;
};

/// None if the person does not exist.
Result<std::optional<Known>> beginSigningIn(Core& core, const std::string& name, const std::string& address) {
  std::int64_t wait_s = 0, addressWait_s = 0;
  auto known = inTransaction(core, Way::Log, [&](Transaction& transaction) -> Result<std::optional<Known>> {
    if (!address.empty()) addressWait_s = secondsAddressLocked(transaction, address, core.moment());
    if (addressWait_s > 0) return std::nullopt;
    wait_s = secondsLocked(transaction, name, core.moment());
    return findByName(transaction, name);
  });
  if (known && addressWait_s > 0)
    return fail("There were too many wrong passwords from this network address. Try again in " +
                std::to_string(addressWait_s) + " s.");
  if (known && wait_s > 0)
    return fail("There were too many wrong passwords for this name. Try again in " + std::to_string(wait_s) +
                " s, or let an instructor set a new password.");
  return known;
}

Result<void> endSigningIn(Core& core, const std::string& name, const std::string& address,
                          const std::optional<Known>& known, bool fits) {
  return inTransaction(core, Way::Log, [&](Transaction& transaction) -> Result<void> {
    if (fits) resetFailures(transaction, name);
    if (!fits) countFailure(transaction, name, core.moment());
    if (!fits && !address.empty()) countAddressFailure(transaction, address, core.moment());
    // Only ids of existing people are logged, since a text in the field of the name may be a password.
    core.audit(transaction, fits ? known->person.id : "", "sign in", known ? known->person.id : "", "", fits);
    return {};
  });
}

bool isText(const std::string& name, const std::string& password) {
  return checkText("The name", name) && checkText("The password", password);
}

/// A name that was copied from a table may have blanks around it, also no-break spaces (writeFirstPasswords()).
std::string withoutBlanks(const std::string& name) {
  return QString::fromStdString(name).trimmed().toStdString();
}

}  // namespace

Result<Known> provePassword(Core& core, const std::string& typed, const std::string& password,
                            const std::string& address) {
  if (!isText(typed, password)) return fail(kWrong);
  const std::string name = withoutBlanks(typed);
  const Turn turn(nameKey(name));
  const auto known = beginSigningIn(core, name, address);
  if (!known) return tl::unexpected(known.error());
  const std::string& hashed = *known ? (*known)->hashed : hashOfNobody(core.passwordCost());
  const bool fits = fitsPassword(password, hashed) && *known && !(*known)->person.disabled;
  if (auto ended = endSigningIn(core, name, address, *known, fits); !ended) return tl::unexpected(ended.error());
  if (!fits) return fail(kWrong);
  return **known;
}

}  // namespace insonate::store
