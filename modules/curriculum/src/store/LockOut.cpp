#include "store/LockOut.h"

#include "store/Texts.h"

#include <algorithm>

namespace insonate::store {
namespace {

constexpr std::int64_t kSecond_us = 1'000'000, kDay_us = 24 * 3600 * kSecond_us;
constexpr std::int64_t kFreeTries = 5, kFirstLock_s = 30, kLongestLock_s = 3600;
constexpr std::int64_t kFreeTriesOfAddress = 30, kTryOfAddress_us = 60 * kSecond_us;

std::string keyOf(const std::string& name) {
  return sha256(nameKey(name));
}

/// No name has such a key: hashes are hexadecimal.
std::string keyOfAddress(const std::string& address) {
  return "address " + sha256(address);
}

void deleteOld(Transaction& transaction, const Moment& moment) {
  // A day without a failure deletes the entries; otherwise invented names would fill the table.
  transaction.run("DELETE FROM sign_in_failures WHERE (boot = ? AND up_us < ?) OR (boot <> ? AND last_us < ?)",
                  moment.boot, moment.up_us - kDay_us, moment.boot, moment.now_us - kDay_us);
}

}  // namespace

std::int64_t lockAfter_us(std::int64_t failures) {
  if (failures < kFreeTries) return 0;
  const std::int64_t doublings = std::min<std::int64_t>(failures - kFreeTries, 10);
  return std::min(kFirstLock_s << doublings, kLongestLock_s) * kSecond_us;
}

std::int64_t secondsLockedAfterTry(Transaction& transaction, const std::string& name, const Moment& moment) {
  deleteOld(transaction, moment);
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

std::int64_t secondsAddressLockedAfterTry(Transaction& transaction, const std::string& address, const Moment& moment) {
  deleteOld(transaction, moment);
  const std::string key = keyOfAddress(address);
  const auto row =
      transaction.row("SELECT failures, last_us, boot, up_us FROM sign_in_failures WHERE name_hash = ?", key);
  if (!row) {
    transaction.run("INSERT INTO sign_in_failures VALUES (?, 1, ?, ?, ?)", key, moment.now_us, moment.boot,
                    moment.up_us);
    return 0;
  }
  const bool sameStart = row->text(2) == moment.boot;
  const std::int64_t elapsed_us =
      std::max<std::int64_t>(sameStart ? moment.up_us - row->number(3) : moment.now_us - row->number(1), 0);
  const std::int64_t failures = std::max<std::int64_t>(row->number(0) - elapsed_us / kTryOfAddress_us, 0);
  const std::int64_t begun_us = elapsed_us % kTryOfAddress_us;
  const bool isLocked = failures >= kFreeTriesOfAddress;
  // The begun minute goes on, else frequent tries would never be forgiven.
  transaction.run("UPDATE sign_in_failures SET failures = ?, last_us = ?, boot = ?, up_us = ? WHERE name_hash = ?",
                  failures + (isLocked ? 0 : 1), moment.now_us - begun_us, moment.boot, moment.up_us - begun_us, key);
  return isLocked ? (kTryOfAddress_us - begun_us + kSecond_us - 1) / kSecond_us : 0;
}

void discountTry(Transaction& transaction, const std::string& address) {
  transaction.run("UPDATE sign_in_failures SET failures = failures - 1 WHERE name_hash = ? AND failures > 0",
                  keyOfAddress(address));
}

void resetFailures(Transaction& transaction, const std::string& name) {
  transaction.run("DELETE FROM sign_in_failures WHERE name_hash = ?", keyOf(name));
}

}  // namespace insonate::store
