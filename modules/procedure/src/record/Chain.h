#pragma once

#include "record/Block.h"

#include <insonate/procedure/RecordingProof.h>

#include <optional>
#include <span>
#include <vector>

/// The chain over a file's blocks (format 4). Each block is followed by a link, a block of its own: the digest d(n) =
/// BLAKE2b(d(n-1), block n), d(0) = 32 zero bytes, and, with a key, the code BLAKE2b(key, d(n)); both of 256 bits (RFC
/// 7693). A digest reveals a damaged byte anywhere; a code cannot be made without the key, and covers all blocks
/// before it.
namespace insonate::record {

using Digest = std::array<std::uint8_t, 32>;

struct Link {
  Digest digest{};
  std::optional<Digest> code{};  ///< none: recorded without a key
};

Digest codeOf(const Digest& digest, const RecordKey& key);

/// Writes links, for the recorder.
class ChainWriter {
 public:
  explicit ChainWriter(const std::optional<RecordKey>& key) : key_(key) {}
  /// The next block, with its link behind it.
  Bytes linked(Bytes block);

 private:
  std::optional<RecordKey> key_;
  Digest digest_{};
};

/// A block where it lies in a file.
struct PlacedBlock {
  BlockHead head{};
  std::size_t at = 0;
  bool agrees = true;  ///< with the links

  std::size_t payload() const { return at + BlockHead::kBytes; }
};

/// A place at which blocks and links of a file disagree.
struct ChainFault {
  enum class Kind {
    Block,    ///< the block at `block` is not the one that was recorded
    Missing,  ///< a block that was recorded is gone
    Link,     ///< a link cannot be read
  };
  Kind kind = Kind::Block;
  std::size_t block = 0;  ///< of Kind::Block: index into the blocks
  std::int64_t time_us = 0;
};

struct ChainReading {
  std::vector<Link> links{};  ///< those that can be read
  std::vector<ChainFault> faults{};
};

/// Compares the blocks of a file with its links and says of each block whether it agrees. Removes the links from the
/// list, and the blocks after the last link: nothing proves that these are whole, as at the end of a truncated file.
ChainReading checkChain(std::span<const std::uint8_t> file, std::vector<PlacedBlock>& blocks);

}  // namespace insonate::record
