#pragma once

#include "record/Bytes.h"

#include <array>
#include <optional>

/// Blocks of a recording's file. Each block is independent: it begins with the bytes kMark, head and contents have
/// checksums, and the contents are compressed with zlib. All numbers are little-endian.
namespace insonate::record {

inline constexpr std::array<std::uint8_t, 8> kMark{0xD1, 'I', 'N', 'S', 'O', '\r', '\n', 0x1A};

enum class BlockKind : std::uint32_t { Header = 1, RecordingSegment = 2, End = 3, Settings = 4, Link = 5 };

struct BlockHead {
  static constexpr std::size_t kBytes = 8 + 4 * 4 + 2 * 8 + 4;
  BlockKind kind = BlockKind::Header;
  std::uint32_t packedBytes = 0, rawBytes = 0;
  std::uint32_t checksum = 0;  ///< CRC-32 of the compressed contents
  std::int64_t first_us = 0, last_us = 0;
};

/// Maximum size of a block in bytes; a larger size in a file indicates damage. Recorded blocks are much smaller.
inline constexpr std::uint32_t kMaxBytes = 64U << 20;

/// Maximum sizes of settings in bytes after decompression: of the header or of one change, and of the header and all
/// changes together. A text of equal characters compresses to a thousandth, so that a small file could otherwise fill
/// the memory of a server. Settings have a few kilobytes.
inline constexpr std::uint32_t kMaxSettingsBytes = 4U << 20, kMaxBytesOfAllSettings = 256U << 20;

/// Makes a block: head and compressed contents. `first_us`, `last_us`: time range of the contents.
Bytes packed(BlockKind kind, std::int64_t first_us, std::int64_t last_us, std::span<const std::uint8_t> content);
/// Parses the head of a block at the beginning of `bytes`; empty if there is no head or if it is damaged.
std::optional<BlockHead> headAt(std::span<const std::uint8_t> bytes);
/// Decompresses the contents of a block; empty if checksum or zlib report damage.
std::optional<Bytes> unpacked(std::span<const std::uint8_t> packedBytes, std::size_t rawBytes, std::uint32_t checksum);

}  // namespace insonate::record
