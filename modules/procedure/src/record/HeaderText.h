#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptHeader.h>

#include <string>
#include <string_view>

namespace insonate::record {

struct HeaderRead {
  AttemptHeader header{};
  bool isChained = false;  ///< the file's blocks have links (record/Chain.h)
};

/// Writes a header as JSON.
std::string textOf(const AttemptHeader& header);
/// Parses a header. Fails with a sentence on other text, and on a format that is newer than this program's.
Result<HeaderRead> headerFrom(std::string_view text);

}  // namespace insonate::record
