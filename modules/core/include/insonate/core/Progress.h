#pragma once

#include <functional>
#include <string_view>

namespace insonate {

/// Callback by which long work reports the present task and the completed share (0..1), on the working thread. If the
/// callback returns false, the work fails with kCancelled within a second. An empty function is allowed.
using Progress = std::function<bool(std::string_view doing, double fraction)>;

inline constexpr std::string_view kCancelled = "Cancelled.";

/// Reports progress; returns false if the listener asks for cancellation.
inline bool report(const Progress& progress, std::string_view doing, double fraction) {
  return !progress || progress(doing, fraction);
}

}  // namespace insonate
