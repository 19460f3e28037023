#pragma once

#include <insonate/core/Result.h>

#include <cstdint>
#include <limits>
#include <string>

namespace insonate::store {

inline Result<void> checkPage(int count) {
  if (count >= 1 && count <= 1000) return {};
  return fail("A page of " + std::to_string(count) + " rows was asked for; a page has 1 to 1000.");
}

/// Returns the number below which the entries of a page lie; `before` 0: no limit, so that the page starts at the
/// newest entry.
inline std::int64_t endOfPage(std::int64_t before) {
  return before > 0 ? before : std::numeric_limits<std::int64_t>::max();
}

}  // namespace insonate::store
