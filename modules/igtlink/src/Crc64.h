#pragma once

#include <boost/crc.hpp>

#include <cstdint>
#include <span>

namespace insonate {

/// Returns the CRC of ECMA-182 over `bytes`: polynomial 0x42F0E1EBA9EA3693, most significant bit first, initial value
/// 0.
inline std::uint64_t crc64(std::span<const std::uint8_t> bytes) {
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693, 0, 0, false, false> crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

}  // namespace insonate
