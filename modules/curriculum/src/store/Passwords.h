#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <string>

namespace insonate::store {

/// argon2id with its salt and cost, as libsodium writes it. Takes 0.1 s and 64 MB; fails where that is not to be had.
Result<std::string> hashedPassword(const std::string& password, PasswordCost cost);
/// Checks and hashes a password that was typed or handed in. Call outside of any transaction, since it takes its time.
Result<std::string> checkedAndHashed(const std::string& password, PasswordCost cost);
bool fitsPassword(const std::string& password, const std::string& hashed);
/// A hash that no password fits, at the usual cost: it is verified when there is no such person.
const std::string& hashOfNobody(PasswordCost cost);

}  // namespace insonate::store
