#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <filesystem>
#include <span>
#include <string>

namespace insonate {

/// Makes a random password for a new account: 12 characters out of 31 letters and digits that are not easily confused
/// (59 bits), in groups of four.
std::string generateFirstPassword();

/// A new person with the password to be given to that person.
struct FirstPassword {
  NewPerson person{};
  std::string password{};
};

/// Writes people and passwords as CSV to a new file that only its owner can read. Fails if the file exists, since it
/// may contain passwords of an earlier import. A name that begins with =, +, - or @ is written after a no-break space,
/// so that no spreadsheet interprets the name as a formula; parseClassList() and CurriculumStore::signIn() ignore the
/// space.
Result<void> writeFirstPasswords(const std::filesystem::path& file, std::span<const FirstPassword> passwords);

}  // namespace insonate
