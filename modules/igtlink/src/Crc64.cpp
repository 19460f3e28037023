#include "Crc64.h"

#include <array>
#include <cstddef>

namespace insonate {
namespace {

constexpr std::uint64_t kPolynomial = 0x42F0E1EBA9EA3693;
using Tables = std::array<std::array<std::uint64_t, 256>, 8>;

/// Table k has the CRC of a byte that k zero bytes follow, so that eight bytes take eight look-ups that do not wait for
/// each other: the CRC of an image of half a megabyte takes a fifth of the time of one table.
constexpr Tables makeTables() {
  Tables tables{};
  for (std::uint64_t byte = 0; byte < 256; ++byte) {
    std::uint64_t crc = byte << 56;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ ((crc >> 63) != 0 ? kPolynomial : 0);
    tables[0][byte] = crc;
  }
  for (std::size_t k = 1; k < tables.size(); ++k)
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint64_t former = tables[k - 1][byte];
      tables[k][byte] = (former << 8) ^ tables[0][former >> 56];
    }
  return tables;
}
constexpr Tables kTables = makeTables();

}  // namespace

std::uint64_t crc64(std::span<const std::uint8_t> bytes) {
  std::uint64_t crc = 0;
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t next = 0;
    for (std::size_t k = 0; k < 8; ++k) {
      const std::uint64_t byte = ((crc >> (56 - 8 * k)) & 0xFF) ^ bytes[i + k];
      next ^= kTables[7 - k][byte];
    }
    crc = next;
  }
  for (; i < bytes.size(); ++i) crc = (crc << 8) ^ kTables[0][(crc >> 56) ^ bytes[i]];
  return crc;
}

}  // namespace insonate
