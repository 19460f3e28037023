#pragma once

#include <functional>
#include <string_view>

namespace insonate {

/// Reports the progress of long work: the present task and the completed share (0..1). Returning false asks for
/// cancellation; the work then fails within a second with kCancelled. May be empty. Called on the working thread.
using Progress = std::function<bool(std::string_view doing, double fraction)>;

inline constexpr std::string_view kCancelled = "Cancelled.";

/// Reports progress; false if the listener asks for cancellation.
inline bool report(const Progress& progress, std::string_view doing, double fraction) {
  return !progress || progress(doing, fraction);
}

}  // namespace insonate
