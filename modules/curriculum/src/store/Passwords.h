#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <string>

namespace insonate::store {

/// Hashes a password with argon2id; the result contains salt and cost in the format of libsodium. Takes 0.1 s and 64
/// MB; fails if the memory is not available.
Result<std::string> hashedPassword(const std::string& password, PasswordCost cost);
/// Checks and hashes a password that a user entered. Call it outside of any transaction, since it takes 0.1 s.
Result<std::string> checkedAndHashed(const std::string& password, PasswordCost cost);
bool fitsPassword(const std::string& password, const std::string& hashed);
/// Makes 32 random bytes, hexadecimal; empty if the system has no random numbers.
std::string randomToken();
/// Returns a hash that no password matches. It is verified if a person does not exist, so that the reply takes the same
/// time as for an existing person.
const std::string& hashOfNobody(PasswordCost cost);

}  // namespace insonate::store
