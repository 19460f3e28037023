#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Appends numbers and texts to a message. Numbers are big-endian.
class BigEndianWriter {
 public:
  explicit BigEndianWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}

  template <class Integer>
  void integer(Integer value) {
    for (int shift = 8 * (static_cast<int>(sizeof value) - 1); shift >= 0; shift -= 8)
      bytes_.push_back(static_cast<std::uint8_t>(value >> shift));
  }
  void real(double value) { integer(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
  /// Appends at most `size` bytes of the text, and zeros up to `size`.
  void text(std::string_view text, std::size_t size) {
    text = text.substr(0, size);
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    bytes_.resize(bytes_.size() + size - text.size());
  }
  void raw(std::span<const std::uint8_t> data) { bytes_.insert(bytes_.end(), data.begin(), data.end()); }

 private:
  std::vector<std::uint8_t>& bytes_;
};

/// Reads numbers and texts of a message in their order. Reading beyond the end returns zeros and sets isPastEnd().
class BigEndianReader {
 public:
  explicit BigEndianReader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  template <class Integer>
  Integer integer() {
    Integer value = 0;
    for (const std::uint8_t byte : take(sizeof value)) value = static_cast<Integer>((std::uint64_t{value} << 8) | byte);
    return value;
  }
  float real() { return std::bit_cast<float>(integer<std::uint32_t>()); }
  /// Returns the next `size` bytes up to the first zero.
  std::string text(std::size_t size) {
    const auto part = take(size);
    std::string text(part.begin(), part.end());
    return text.substr(0, text.find('\0'));
  }
  std::span<const std::uint8_t> take(std::size_t size) {
    if (size > bytes_.size()) {
      pastEnd_ = true, bytes_ = {};
      return {};
    }
    const auto part = bytes_.first(size);
    bytes_ = bytes_.subspan(size);
    return part;
  }
  std::size_t left() const { return bytes_.size(); }
  bool isPastEnd() const { return pastEnd_; }

 private:
  std::span<const std::uint8_t> bytes_;
  bool pastEnd_ = false;
};

}  // namespace insonate
