#include "HandsHash.h"

#include <sodium/crypto_generichash_blake2b.h>
#include <sodium/utils.h>

#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

namespace insonate {
namespace {

/// BLAKE2b (RFC 7693), 256 bits, of numbers as 8 bytes each, the lowest first.
class Hasher {
 public:
  Hasher() { crypto_generichash_blake2b_init(&state_, nullptr, 0, kBytes); }

  void put(std::uint64_t number) {
    std::array<unsigned char, 8> bytes;
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<unsigned char>(number >> (8 * i));
    crypto_generichash_blake2b_update(&state_, bytes.data(), bytes.size());
  }
  void put(double number) { put(std::bit_cast<std::uint64_t>(number)); }
  void put(const Vec3& vector) { put(vector.x), put(vector.y), put(vector.z); }
  void put(const QuantizedSample& sample) {
    put(static_cast<std::uint64_t>(sample.time_us));
    for (const std::int32_t value : sample.channel) put(static_cast<std::uint64_t>(value));
  }
  void put(const AttemptEvent& event) {
    put(static_cast<std::uint64_t>(event.time_us));
    for (const auto code : {static_cast<std::uint64_t>(event.kind), static_cast<std::uint64_t>(event.wall),
                            static_cast<std::uint64_t>(event.into), static_cast<std::uint64_t>(event.vessel)})
      put(code);
    put(event.tip_mm), put(event.axis), put(event.depth_mm), put(event.tilt_deg);
    put(static_cast<std::uint64_t>(event.outward.has_value()));
    if (event.outward) put(*event.outward);
  }

  std::string digits() {
    std::array<unsigned char, kBytes> hash;
    crypto_generichash_blake2b_final(&state_, hash.data(), hash.size());
    std::array<char, 2 * kBytes + 1> digits;
    return sodium_bin2hex(digits.data(), digits.size(), hash.data(), hash.size());
  }

 private:
  static constexpr std::size_t kBytes = 32;
  crypto_generichash_blake2b_state state_;
};

}  // namespace

Result<std::string> handsHash(const AttemptRecording& recording) {
  Hasher hasher;
  std::uint64_t samples = 0;
  std::optional<QuantizedSample> first;
  bool isMoving = false;
  std::vector<AttemptEvent> events;
  for (std::size_t i = 0; i < recording.segmentCount(); ++i) {
    const auto segment = recording.segment(i);
    if (!segment) return tl::unexpected(segment.error());
    for (const QuantizedSample& sample : segment->samples) {
      if (!first) first = sample;
      isMoving |= sample.channel != first->channel;
      hasher.put(sample);
    }
    samples += segment->samples.size();
    for (const RecordingSegment::PlacedEvent& happened : segment->events) events.push_back(happened.event);
  }
  if (!isMoving && events.empty()) return std::string();
  hasher.put(samples);
  for (const AttemptEvent& event : events) hasher.put(event);
  return hasher.digits();
}

}  // namespace insonate
