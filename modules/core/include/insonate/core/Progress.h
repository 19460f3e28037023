#pragma once

#include <functional>
#include <string_view>

namespace insonate {

/// Callback for the progress of a long computation. `doing` names the present task; `fraction` is the completed share,
/// 0 to 1. The callback runs on the thread that computes. If the callback returns false, the computation fails with
/// kCancelled within a second. The function may be empty.
using Progress = std::function<bool(std::string_view doing, double fraction)>;

inline constexpr std::string_view kCancelled = "Cancelled.";

/// Reports progress to the callback. Returns false if the callback asks for cancellation.
inline bool report(const Progress& progress, std::string_view doing, double fraction) {
  return !progress || progress(doing, fraction);
}

}  // namespace insonate
