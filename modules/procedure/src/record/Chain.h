#pragma once

#include "record/Block.h"

#include <insonate/procedure/RecordingProof.h>

#include <optional>
#include <span>
#include <vector>

/// Chain of digests over the blocks of a recording's file (format 4). Each block is followed by a link, which is itself
/// a block. The link of block n contains the digest d(n) = BLAKE2b(d(n-1), block n), with d(0) = 32 zero bytes, and, if
/// there is a key, the code BLAKE2b(key, d(n)). Both have 256 bits (RFC 7693). A digest reveals a damaged byte
/// anywhere. A code cannot be made without the key, and covers all earlier blocks.
namespace insonate::record {

using Digest = std::array<std::uint8_t, 32>;

struct Link {
  Digest digest{};
  std::optional<Digest> code{};  ///< authentication code of all blocks so far; empty: recorded without a key
};

Digest codeOf(const Digest& digest, const RecordKey& key);

/// Adds links (digests) to the blocks of a recording while it is written.
class ChainWriter {
 public:
  explicit ChainWriter(const std::optional<RecordKey>& key) : key_(key) {}
  /// Returns `block`, the next of the file, followed by its link.
  Bytes linked(Bytes block);

 private:
  std::optional<RecordKey> key_;
  Digest digest_{};
};

/// A block and its position in a recording's file.
struct PlacedBlock {
  BlockHead head{};
  std::size_t at = 0;
  bool agrees = true;  ///< true: the block agrees with the digests in the links

  std::size_t payload() const { return at + BlockHead::kBytes; }
};

/// A place at which blocks and links (digests) of a recording disagree.
struct ChainFault {
  enum class Kind {
    Block,    ///< the block with the index ChainFault::block was changed
    Missing,  ///< a block is missing
    Link,     ///< a link cannot be read
  };
  Kind kind = Kind::Block;
  std::size_t block = 0;  ///< for Kind::Block: index of the changed block
  std::int64_t time_us = 0;
};

struct ChainReading {
  std::vector<Link> links{};  ///< links (digests) of the file that could be read, in their order
  std::vector<ChainFault> faults{};
};

/// Compares the blocks of a recording with the digests in its links, and clears PlacedBlock::agrees of each block that
/// disagrees. Removes from `blocks` the links, and the blocks after the last link (in a truncated file), whose
/// completeness cannot be checked.
ChainReading checkChain(std::span<const std::uint8_t> file, std::vector<PlacedBlock>& blocks);

}  // namespace insonate::record
