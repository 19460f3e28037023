#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <filesystem>
#include <span>
#include <string>

namespace insonate {

/// A password to hand over, by chance: 12 of 31 letters and digits that are not taken for one another, 59 bits, in
/// groups of four.
std::string firstPassword();

/// Whom it is handed to.
struct FirstPassword {
  NewPerson person{};
  std::string password{};
};

/// CSV with a line for each, in a new file that its owner alone can read. Fails where the file is there already: it may
/// hold passwords of an earlier import.
Result<void> writeFirstPasswords(const std::filesystem::path& file, std::span<const FirstPassword> passwords);

}  // namespace insonate
