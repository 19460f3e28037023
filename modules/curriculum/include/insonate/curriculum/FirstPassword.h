#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <filesystem>
#include <span>
#include <string>

namespace insonate {

/// Makes a random password to hand over: 12 of 31 letters and digits that cannot be confused with each other, 59 bits,
/// in groups of four.
std::string firstPassword();

/// A person with the password to hand over.
struct FirstPassword {
  NewPerson person{};
  std::string password{};
};

/// Writes CSV with one line for each password, to a new file that only its owner can read. Fails if the file exists,
/// since it may hold passwords of an earlier import.
Result<void> writeFirstPasswords(const std::filesystem::path& file, std::span<const FirstPassword> passwords);

}  // namespace insonate
