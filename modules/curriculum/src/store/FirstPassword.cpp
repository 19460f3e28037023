#include <insonate/curriculum/FirstPassword.h>

#include <sodium/core.h>
#include <sodium/randombytes.h>

#include <string_view>

namespace insonate {

std::string firstPassword() {
  constexpr std::string_view kLetters = "abcdefghjkmnpqrstuvwxyz23456789";
  std::string made;
  if (sodium_init() < 0) return made;
  for (int n = 0; n < 12; ++n) {
    if (n > 0 && n % 4 == 0) made += '-';
    made += kLetters[randombytes_uniform(kLetters.size())];
  }
  return made;
}

}  // namespace insonate
