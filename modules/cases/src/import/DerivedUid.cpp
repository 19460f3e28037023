#include "DerivedUid.h"

#include <itksys/MD5.h>

#include <algorithm>
#include <array>
#include <memory>

namespace insonate {

std::string derivedUid(std::string_view text) {
  const std::unique_ptr<itksysMD5, decltype(&itksysMD5_Delete)> md5(itksysMD5_New(), &itksysMD5_Delete);
  itksysMD5_Initialize(md5.get());
  itksysMD5_Append(md5.get(), reinterpret_cast<const unsigned char*>(text.data()), static_cast<int>(text.size()));
  std::array<unsigned char, 16> uuid;
  itksysMD5_Finalize(md5.get(), uuid.data());
  uuid[6] = static_cast<unsigned char>((uuid[6] & 0x0f) | 0x30);
  uuid[8] = static_cast<unsigned char>((uuid[8] & 0x3f) | 0x80);

  // Decimal digits of the 128-bit number by long division.
  std::string digits;
  while (std::ranges::any_of(uuid, [](unsigned char b) { return b != 0; })) {
    unsigned remainder = 0;
    for (unsigned char& byte : uuid) {
      const unsigned value = remainder * 256 + byte;
      byte = static_cast<unsigned char>(value / 10);
      remainder = value % 10;
    }
    digits += static_cast<char>('0' + remainder);
  }
  std::ranges::reverse(digits);
  return "2.25." + digits;
}

}  // namespace insonate
