#pragma once

#include <functional>
#include <string_view>

namespace insonate {

/// Reports long work: what is being done and how far it is (0..1). Returning false asks for cancellation, which the
/// work honours within a second by failing with kCancelled. May be empty. Called on the working thread.
using Progress = std::function<bool(std::string_view doing, double fraction)>;

inline constexpr std::string_view kCancelled = "Cancelled.";

/// True unless the listener asks for cancellation.
inline bool report(const Progress& progress, std::string_view doing, double fraction) {
  return !progress || progress(doing, fraction);
}

}  // namespace insonate
