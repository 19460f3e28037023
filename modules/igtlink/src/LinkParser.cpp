#include "BigEndian.h"
#include "Crc64.h"
#include "LinkTime.h"

#include <insonate/igtlink/LinkParser.h>

#include <algorithm>
#include <utility>

namespace insonate {
namespace {

constexpr std::uint16_t kMaxVersion = 3;
/// A larger body is taken as a sign that the bytes are not a header.
constexpr std::uint64_t kMaxSkipped = std::uint64_t{4} << 30;
constexpr std::size_t kExtendedHeaderSize = 12;

bool isType(const std::string& type) {
  return !type.empty() && std::ranges::all_of(type, [](char c) { return c > ' ' && c < 0x7F; });
}

/// The content within the body of a header of version 2 or 3: after the extended header, and before the metadata.
std::optional<std::span<const std::uint8_t>> contentOf(std::span<const std::uint8_t> body) {
  BigEndianReader reader(body);
  const std::size_t extended = reader.integer<std::uint16_t>(), metadataIndex = reader.integer<std::uint16_t>(),
                    metadata = reader.integer<std::uint32_t>();
  if (reader.isPastEnd() || extended < kExtendedHeaderSize) return std::nullopt;
  if (extended + metadataIndex + metadata > body.size()) return std::nullopt;
  return body.subspan(extended, body.size() - extended - metadataIndex - metadata);
}

}  // namespace

Result<void> LinkParser::feed(std::span<const std::uint8_t> bytes, const Take& take) {
  if (!error_.empty()) return fail(error_);
  while (!bytes.empty()) {
    const std::uint64_t missing = inBody_ ? bodyLeft_ : kLinkHeaderSize - part_.size();
    const auto next = bytes.first(static_cast<std::size_t>(std::min<std::uint64_t>(missing, bytes.size())));
    bytes = bytes.subspan(next.size());
    if (!inBody_ || wanted_) part_.insert(part_.end(), next.begin(), next.end());
    if (inBody_)
      bodyLeft_ -= next.size();
    else if (part_.size() == kLinkHeaderSize)
      if (auto ok = beginBody(); !ok) return ok;
    if (inBody_ && bodyLeft_ == 0) endBody(take);
  }
  return {};
}

Result<void> LinkParser::beginBody() {
  BigEndianReader reader(part_);
  const auto version = reader.integer<std::uint16_t>();
  message_ = {};
  message_.version = version;
  message_.type = reader.text(kLinkTypeSize);
  message_.device = reader.text(kLinkDeviceSize);
  message_.time_ns = linkTime_ns(reader.integer<std::uint64_t>());
  bodyLeft_ = reader.integer<std::uint64_t>();
  crc_ = reader.integer<std::uint64_t>();
  part_.clear();
  if (version < 1 || version > kMaxVersion || !isType(message_.type) || bodyLeft_ > kMaxSkipped) {
    error_ = "The other program does not speak OpenIGTLink: it sent a header that is not valid.";
    return fail(error_);
  }
  inBody_ = true;
  wanted_ = bodyLeft_ <= kMaxBody && std::ranges::find(types_, message_.type) != types_.end();
  return {};
}

void LinkParser::endBody(const Take& take) {
  inBody_ = false;
  const std::vector<std::uint8_t> body = std::exchange(part_, {});
  if (!wanted_) {
    ++counters_.skipped;
    return;
  }
  const auto content = message_.version > 1 ? contentOf(body) : std::span<const std::uint8_t>(body);
  if (crc64(body) != crc_ || !content) {
    ++counters_.damaged;
    return;
  }
  message_.content.assign(content->begin(), content->end());
  ++counters_.taken;
  take(std::exchange(message_, {}));
}

}  // namespace insonate
