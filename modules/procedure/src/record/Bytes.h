#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

/// Conversion of numbers to bytes and back, little-endian on every computer.
namespace insonate::record {

using Bytes = std::vector<std::uint8_t>;

template <std::unsigned_integral T>
void put(Bytes& bytes, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}
inline void put(Bytes& bytes, std::int64_t value) {
  put(bytes, static_cast<std::uint64_t>(value));
}
inline void put(Bytes& bytes, double value) {
  put(bytes, std::bit_cast<std::uint64_t>(value));
}

/// Reads numbers one after another from bytes. Numbers beyond the end read as 0, after which isWhole() is false.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <std::unsigned_integral T>
  T get() {
    if (bytes_.size() < sizeof(T)) {
      whole_ = false, bytes_ = {};
      return 0;
    }
    T value = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) value = static_cast<T>(value | static_cast<T>(bytes_[i]) << (8 * i));
    bytes_ = bytes_.subspan(sizeof(T));
    return value;
  }
  std::int64_t getTime() { return static_cast<std::int64_t>(get<std::uint64_t>()); }
  double getDouble() { return std::bit_cast<double>(get<std::uint64_t>()); }

  std::size_t left() const { return bytes_.size(); }
  bool isWhole() const { return whole_; }

 private:
  std::span<const std::uint8_t> bytes_;
  bool whole_ = true;
};

}  // namespace insonate::record
