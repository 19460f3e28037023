#pragma once

#include "record/Block.h"

#include <insonate/procedure/RecordingProof.h>

#include <optional>
#include <span>
#include <vector>

/// The chain over a file's blocks (format 4). Each block is followed by a link, which is itself a block. The link of
/// block n contains the digest d(n) = BLAKE2b(d(n-1), block n), with d(0) = 32 zero bytes, and, if there is a key, the
/// code BLAKE2b(key, d(n)). Both have 256 bits (RFC 7693). A digest reveals a damaged byte anywhere. A code cannot be
/// made without the key, and covers all earlier blocks.
namespace insonate::record {

using Digest = std::array<std::uint8_t, 32>;

struct Link {
  Digest digest{};
  std::optional<Digest> code{};  ///< empty: recorded without a key
};

Digest codeOf(const Digest& digest, const RecordKey& key);

/// Adds links to blocks, for the recorder.
class ChainWriter {
 public:
  explicit ChainWriter(const std::optional<RecordKey>& key) : key_(key) {}
  /// Returns the next block followed by its link.
  Bytes linked(Bytes block);

 private:
  std::optional<RecordKey> key_;
  Digest digest_{};
};

/// A block and its position in a file.
struct PlacedBlock {
  BlockHead head{};
  std::size_t at = 0;
  bool agrees = true;  ///< the block agrees with the links

  std::size_t payload() const { return at + BlockHead::kBytes; }
};

/// A place at which blocks and links of a file disagree.
struct ChainFault {
  enum class Kind {
    Block,    ///< the block at `block` differs from the recorded block
    Missing,  ///< a recorded block is missing
    Link,     ///< a link cannot be read
  };
  Kind kind = Kind::Block;
  std::size_t block = 0;  ///< for Kind::Block: index into the blocks
  std::int64_t time_us = 0;
};

struct ChainReading {
  std::vector<Link> links{};  ///< the readable links
  std::vector<ChainFault> faults{};
};

/// Compares the blocks of a file with its links and marks each block that disagrees. Removes the links from the list.
/// Also removes the blocks after the last link, as at the end of a truncated file, since nothing proves that these are
/// complete.
ChainReading checkChain(std::span<const std::uint8_t> file, std::vector<PlacedBlock>& blocks);

}  // namespace insonate::record
