#pragma once

#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptHeader.h>

#include <string>
#include <string_view>

namespace insonate::record {

/// JSON.
std::string textOf(const AttemptHeader& header);
/// Fails with a sentence on other text, and on a format that is newer than this program's.
Result<AttemptHeader> headerFrom(std::string_view text);

}  // namespace insonate::record
