#pragma once

#include <bit>
#include <cctype>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Messages by the published layout of OpenIGTLink (openigtlink.org, "Protocol"), made without the module: header of 58
/// bytes, big-endian; CRC of ECMA-182, bit by bit.
namespace insonate::test {

using Bytes = std::vector<std::uint8_t>;

/// Bytes that are written as hexadecimal digits.
inline Bytes hex(std::string_view digits) {
  Bytes bytes;
  std::string pair;
  for (const char c : digits) {
    if (std::isxdigit(static_cast<unsigned char>(c)) != 0) pair += c;
    if (pair.size() == 2) {
      bytes.push_back(static_cast<std::uint8_t>(std::strtoul(pair.c_str(), nullptr, 16)));
      pair.clear();
    }
  }
  return bytes;
}

inline std::uint64_t slowCrc(std::span<const std::uint8_t> bytes) {
  std::uint64_t crc = 0;
  for (const std::uint8_t byte : bytes) {
    crc ^= std::uint64_t{byte} << 56;
    for (int bit = 0; bit < 8; ++bit) crc = (crc << 1) ^ ((crc >> 63) != 0 ? 0x42F0E1EBA9EA3693 : 0);
  }
  return crc;
}

inline void put(Bytes& bytes, std::uint64_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}
inline void putText(Bytes& bytes, std::string_view text, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) bytes.push_back(i < text.size() ? static_cast<std::uint8_t>(text[i]) : 0);
}
inline void putReal(Bytes& bytes, float value) {
  put(bytes, std::bit_cast<std::uint32_t>(value), 4);
}

inline Bytes header(int version, std::string_view type, std::string_view device, std::uint64_t size,
                    std::uint64_t crc) {
  Bytes bytes;
  put(bytes, static_cast<std::uint64_t>(version), 2);
  putText(bytes, type, 12);
  putText(bytes, device, 20);
  put(bytes, 0, 8);
  put(bytes, size, 8);
  put(bytes, crc, 8);
  return bytes;
}
inline Bytes message(int version, std::string_view type, std::string_view device, const Bytes& body) {
  Bytes bytes = header(version, type, device, body.size(), slowCrc(body));
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

inline Bytes transformBody(float x, float y, float z) {
  Bytes body;
  for (const float value : {1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, x, y, z}) putReal(body, value);
  return body;
}
inline Bytes stringBody(std::string_view text) {
  Bytes body;
  put(body, 3, 2);
  put(body, text.size(), 2);
  putText(body, text, text.size());
  return body;
}
/// Body of a header of version 2: extended header, content and metadata with one key.
inline Bytes extendedBody(const Bytes& content) {
  Bytes body;
  put(body, 12, 2), put(body, 10, 2), put(body, 8, 4), put(body, 7, 4);
  body.insert(body.end(), content.begin(), content.end());
  put(body, 1, 2), put(body, 6, 2), put(body, 3, 2), put(body, 2, 4);
  putText(body, "StatusOK", 8);
  return body;
}

inline void append(Bytes& bytes, const Bytes& more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

}  // namespace insonate::test
