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

std::int64_t secondsLocked(Transaction& transaction, const std::string& name, const Moment& moment) {
  deleteOld(transaction, moment);
  const std::string key = keyOf(name);
  const auto row =
      transaction.row("SELECT failures, last_us, boot, up_us FROM sign_in_failures WHERE name_hash = ?", key);
  if (!row) return 0;
  const bool sameStart = row->text(2) == moment.boot;
  const std::int64_t elapsed_us = sameStart ? moment.up_us - row->number(3) : moment.now_us - row->number(1);
  if (elapsed_us < 0)
    transaction.run("UPDATE sign_in_failures SET last_us = ?, boot = ?, up_us = ? WHERE name_hash = ?", moment.now_us,
                    moment.boot, moment.up_us, key);
  const std::int64_t wait_us = lockAfter_us(row->number(0)) - std::max<std::int64_t>(elapsed_us, 0);
  return wait_us <= 0 ? 0 : (wait_us + kSecond_us - 1) / kSecond_us;
}

void countFailure(Transaction& transaction, const std::string& name, const Moment& moment) {
  const std::string key = keyOf(name);
  if (transaction.run("UPDATE sign_in_failures SET failures = failures + 1, last_us = ?, boot = ?, up_us = ? "
                      "WHERE name_hash = ?",
                      moment.now_us, moment.boot, moment.up_us, key) == 0)
    transaction.run("INSERT INTO sign_in_failures VALUES (?, 1, ?, ?, ?)", key, moment.now_us, moment.boot,
                    moment.up_us);
}

std::int64_t secondsLockedAfterTry(Transaction& transaction, const std::string& name, const Moment& moment) {
  const std::int64_t wait_s = secondsLocked(transaction, name, moment);
  if (wait_s == 0) countFailure(transaction, name, moment);
  return wait_s;
}

namespace {

/// Failures of an address that still count, and the time since the last of them was forgiven.
struct AddressCount {
  bool isKnown = false;
  std::int64_t failures = 0, begun_us = 0;
};

AddressCount countOf(Transaction& transaction, const std::string& address, const Moment& moment) {
  const auto row = transaction.row("SELECT failures, last_us, boot, up_us FROM sign_in_failures WHERE name_hash = ?",
                                   keyOfAddress(address));
  if (!row) return {};
  const bool sameStart = row->text(2) == moment.boot;
  const std::int64_t elapsed_us =
      std::max<std::int64_t>(sameStart ? moment.up_us - row->number(3) : moment.now_us - row->number(1), 0);
  return {true, std::max<std::int64_t>(row->number(0) - elapsed_us / kTryOfAddress_us, 0),
          elapsed_us % kTryOfAddress_us};
}

}  // namespace

std::int64_t secondsAddressLocked(Transaction& transaction, const std::string& address, const Moment& moment) {
  deleteOld(transaction, moment);
  const AddressCount count = countOf(transaction, address, moment);
  if (count.failures < kFreeTriesOfAddress) return 0;
  return (kTryOfAddress_us - count.begun_us + kSecond_us - 1) / kSecond_us;
}

void countAddressFailure(Transaction& transaction, const std::string& address, const Moment& moment) {
  const std::string key = keyOfAddress(address);
  const AddressCount count = countOf(transaction, address, moment);
  if (!count.isKnown)
    transaction.run("INSERT INTO sign_in_failures VALUES (?, 1, ?, ?, ?)", key, moment.now_us, moment.boot,
                    moment.up_us);
  else  // The begun minute goes on, else frequent tries would never be forgiven.
    transaction.run("UPDATE sign_in_failures SET failures = ?, last_us = ?, boot = ?, up_us = ? WHERE name_hash = ?",
                    count.failures + 1, moment.now_us - count.begun_us, moment.boot, moment.up_us - count.begun_us,
                    key);
}

std::int64_t secondsAddressLockedAfterTry(Transaction& transaction, const std::string& address, const Moment& moment) {
  const std::int64_t wait_s = secondsAddressLocked(transaction, address, moment);
  if (wait_s == 0) countAddressFailure(transaction, address, moment);
  return wait_s;
}

void discountTry(Transaction& transaction, const std::string& address) {
  transaction.run("UPDATE sign_in_failures SET failures = failures - 1 WHERE name_hash = ? AND failures > 0",
                  keyOfAddress(address));
}

void resetFailures(Transaction& transaction, const std::string& name) {
  transaction.run("DELETE FROM sign_in_failures WHERE name_hash = ?", keyOf(name));
}

}  // namespace insonate::store
