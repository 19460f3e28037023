#include "record/Chain.h"

#include <sodium/crypto_generichash_blake2b.h>

#include <algorithm>

namespace insonate::record {
namespace {

Digest digestAfter(const Digest& before, std::span<const std::uint8_t> block) {
  crypto_generichash_blake2b_state state;
  crypto_generichash_blake2b_init(&state, nullptr, 0, before.size());
  crypto_generichash_blake2b_update(&state, before.data(), before.size());
  crypto_generichash_blake2b_update(&state, block.data(), block.size());
  Digest digest;
  crypto_generichash_blake2b_final(&state, digest.data(), digest.size());
  return digest;
}

/// None if the block is damaged or not a link.
std::optional<Link> linkAt(std::span<const std::uint8_t> file, const PlacedBlock& block) {
  const BlockHead& head = block.head;
  if (head.rawBytes > 2 * Digest().size()) return std::nullopt;
  const auto content = unpacked(file.subspan(block.payload(), head.packedBytes), head.rawBytes, head.checksum);
  Link link;
  const bool hasCode = content && content->size() == 2 * link.digest.size();
  if (!content || (!hasCode && content->size() != link.digest.size())) return std::nullopt;
  std::copy_n(content->begin(), link.digest.size(), link.digest.begin());
  if (hasCode) {
    link.code.emplace();
    std::copy(content->begin() + static_cast<std::ptrdiff_t>(link.digest.size()), content->end(), link.code->begin());
  }
  return link;
}

}  // namespace

Digest codeOf(const Digest& digest, const RecordKey& key) {
  Digest code;
  crypto_generichash_blake2b(code.data(), code.size(), digest.data(), digest.size(), key.data(), key.size());
  return code;
}

Bytes ChainWriter::linked(Bytes block) {
  digest_ = digestAfter(digest_, block);
  Bytes content(digest_.begin(), digest_.end());
  if (key_) {
    const Digest code = codeOf(digest_, *key_);
    content.insert(content.end(), code.begin(), code.end());
  }
  const Bytes link = packed(BlockKind::Link, 0, 0, content);
  block.insert(block.end(), link.begin(), link.end());
  return block;
}

ChainReading checkChain(std::span<const std::uint8_t> file, std::vector<PlacedBlock>& blocks) {
  ChainReading reading;
  std::vector<PlacedBlock> others;
  Digest digest{};
  std::size_t unlinked = 0;  // the first block without a matching link
  std::int64_t time_us = 0;
  for (PlacedBlock& block : blocks) {
    if (block.head.kind != BlockKind::Link) {
      digest = digestAfter(digest, file.subspan(block.at, BlockHead::kBytes + block.head.packedBytes));
      time_us = block.head.last_us;
      others.push_back(block);
      continue;
    }
    const auto link = linkAt(file, block);
    if (!link) {
      reading.faults.push_back({ChainFault::Kind::Link, 0, time_us});
      continue;
    }
    const bool agrees = link->digest == digest;
    if (!agrees && unlinked == others.size()) reading.faults.push_back({ChainFault::Kind::Missing, 0, time_us});
    for (; unlinked < others.size(); ++unlinked) {
      others[unlinked].agrees = agrees;
      if (!agrees) reading.faults.push_back({ChainFault::Kind::Block, unlinked, others[unlinked].head.first_us});
    }
    // The digest as recorded: later blocks are compared with it, so that damage affects only its own block.
    digest = link->digest;
    reading.links.push_back(*link);
  }
  others.resize(unlinked);
  blocks = std::move(others);
  return reading;
}

}  // namespace insonate::record
