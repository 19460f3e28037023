#include <insonate/core/AtomicFile.h>
#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/FirstPassword.h>

#include <sodium/core.h>
#include <sodium/randombytes.h>

#include <fstream>
#include <string_view>
#include <vector>

namespace insonate {

std::string generateFirstPassword() {
  constexpr std::string_view kLetters = "abcdefghjkmnpqrstuvwxyz23456789";
  std::string made;
  if (sodium_init() < 0) return made;
  for (int n = 0; n < 12; ++n) {
    if (n > 0 && n % 4 == 0) made += '-';
    made += kLetters[randombytes_uniform(kLetters.size())];
  }
  return made;
}

namespace {

/// A spreadsheet takes a name that begins with a sign for a formula. It takes a no-break space before the sign for
/// text, and signing in and class lists ignore the space; an apostrophe would become part of the name that people type.
std::string signInCell(const std::string& name) {
  return std::string_view("=+-@").find(name.front()) == std::string_view::npos ? name : "\u00A0" + name;
}

}  // namespace

Result<void> writeFirstPasswords(const std::filesystem::path& file, std::span<const FirstPassword> passwords) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (fs::exists(file, error))
    return fail(file.string() + " exists and may contain passwords of an earlier import. Name another file.");
  std::vector<std::vector<std::string>> rows{{"name", "full name", "e-mail", "first password"}};
  for (const auto& [person, password] : passwords)
    rows.push_back({signInCell(person.name), person.fullName, person.email, password});
  return writeAtomically(file, [&](const fs::path& beside) -> Result<void> {
    std::ofstream stream(beside, std::ios::binary);
    fs::permissions(beside, fs::perms::owner_read | fs::perms::owner_write);
    if (!(stream << csvText(rows) << std::flush)) return fail("Could not write " + beside.string() + ".");
    return {};
  });
}

}  // namespace insonate
