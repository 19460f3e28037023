#include "store/LockOut.h"

#include "store/Texts.h"

#include <algorithm>

namespace insonate::store {
namespace {

constexpr std::int64_t kSecond_us = 1'000'000, kDay_us = 24 * 3600 * kSecond_us;
constexpr std::int64_t kFreeTries = 5, kFirstLock_s = 30, kLongestLock_s = 3600;

std::string keyOf(const std::string& name) {
  return sha256(nameKey(name));
}

}  // namespace

std::int64_t lockAfter_us(std::int64_t failures) {
  if (failures < kFreeTries) return 0;
  const std::int64_t doublings = std::min<std::int64_t>(failures - kFreeTries, 10);
  return std::min(kFirstLock_s << doublings, kLongestLock_s) * kSecond_us;
}

std::int64_t secondsLockedAfterTry(Transaction& transaction, const std::string& name, const Moment& moment) {
  // A day without a failure deletes the entries; otherwise invented names would fill the table.
  transaction.run("DELETE FROM sign_in_failures WHERE (boot = ? AND up_us < ?) OR (boot <> ? AND last_us < ?)",
                  moment.boot, moment.up_us - kDay_us, moment.boot, moment.now_us - kDay_us);
  const std::string key = keyOf(name);
  const auto row =
      transaction.row("SELECT failures, last_us, boot, up_us FROM sign_in_failures WHERE name_hash = ?", key);
  if (!row) {
    transaction.run("INSERT INTO sign_in_failures VALUES (?, 1, ?, ?, ?)", key, moment.now_us, moment.boot,
                    moment.up_us);
    return 0;
  }
  const bool sameStart = row->text(2) == moment.boot;
  const std::int64_t elapsed_us = sameStart ? moment.up_us - row->number(3) : moment.now_us - row->number(1);
  const std::int64_t wait_us = lockAfter_us(row->number(0)) - std::max<std::int64_t>(elapsed_us, 0);
  if (wait_us <= 0 || elapsed_us < 0)
    transaction.run("UPDATE sign_in_failures SET failures = ?, last_us = ?, boot = ?, up_us = ? WHERE name_hash = ?",
                    row->number(0) + (wait_us <= 0 ? 1 : 0), moment.now_us, moment.boot, moment.up_us, key);
  return wait_us <= 0 ? 0 : (wait_us + kSecond_us - 1) / kSecond_us;
}

void resetFailures(Transaction& transaction, const std::string& name) {
  transaction.run("DELETE FROM sign_in_failures WHERE name_hash = ?", keyOf(name));
}

}  // namespace insonate::store
