#pragma once

#include <cstdint>
#include <span>

namespace insonate {

/// Returns the CRC of ECMA-182 over `bytes`: polynomial 0x42F0E1EBA9EA3693, most significant bit first, initial value
/// 0.
std::uint64_t crc64(std::span<const std::uint8_t> bytes);

}  // namespace insonate
