#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptHeader.h>

#include <string>
#include <string_view>

namespace insonate::record {

struct HeaderRead {
  AttemptHeader header{};
  bool isChained = false;  ///< true: the blocks of the recording have digests (record/Chain.h)
};

/// Writes the header of a recording as JSON.
std::string textOf(const AttemptHeader& header);
/// Parses the header of a recording from JSON. Fails with a sentence on invalid text, and on a format that is newer
/// than this program's.
Result<HeaderRead> headerFrom(std::string_view text);

}  // namespace insonate::record
