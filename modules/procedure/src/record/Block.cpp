#include "record/Block.h"

#include <zlib.h>

#include <algorithm>
#include <array>

namespace insonate::record {
namespace {

std::uint32_t checksumOf(std::span<const std::uint8_t> bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

}  // namespace

Bytes packed(BlockKind kind, std::int64_t first_us, std::int64_t last_us, std::span<const std::uint8_t> content) {
  uLongf size = compressBound(static_cast<uLong>(content.size()));
  Bytes body(size);
  // With a sufficient buffer and a valid level, only lack of memory can make this fail.
  if (compress2(body.data(), &size, content.data(), static_cast<uLong>(content.size()), Z_DEFAULT_COMPRESSION) != Z_OK)
    throw std::bad_alloc();
  body.resize(size);

  Bytes block(kMark.begin(), kMark.end());
  put(block, static_cast<std::uint32_t>(kind));
  put(block, static_cast<std::uint32_t>(body.size()));
  put(block, static_cast<std::uint32_t>(content.size()));
  put(block, checksumOf(body));
  put(block, first_us), put(block, last_us);
  put(block, checksumOf(block));
  block.insert(block.end(), body.begin(), body.end());
  return block;
}

std::optional<BlockHead> headAt(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < BlockHead::kBytes || !std::equal(kMark.begin(), kMark.end(), bytes.begin())) return std::nullopt;
  ByteReader reader(bytes.subspan(kMark.size()));
  BlockHead head;
  head.kind = static_cast<BlockKind>(reader.get<std::uint32_t>());
  head.packedBytes = reader.get<std::uint32_t>(), head.rawBytes = reader.get<std::uint32_t>();
  head.checksum = reader.get<std::uint32_t>();
  head.first_us = reader.getTime(), head.last_us = reader.getTime();
  if (reader.get<std::uint32_t>() != checksumOf(bytes.first(BlockHead::kBytes - 4))) return std::nullopt;
  if (head.packedBytes > kMaxBytes || head.rawBytes > kMaxBytes) return std::nullopt;
  return head;
}

std::optional<Bytes> unpacked(std::span<const std::uint8_t> packedBytes, std::size_t rawBytes, std::uint32_t checksum) {
  if (checksumOf(packedBytes) != checksum) return std::nullopt;
  Bytes raw(rawBytes);
  uLongf size = static_cast<uLongf>(rawBytes);
  if (uncompress(raw.data(), &size, packedBytes.data(), static_cast<uLong>(packedBytes.size())) != Z_OK ||
      size != rawBytes)
    return std::nullopt;
  return raw;
}

}  // namespace insonate::record
