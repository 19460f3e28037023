#pragma once

#include <cstddef>
#include <optional>
#include <set>

namespace insonate {
struct AttemptView;
struct Procedure;
}  // namespace insonate

namespace insonate::train {

/// The major or critical error of an attempt that stays on the screen until the needle has left the skin after the
/// error, or until the trainee dismisses the error.
class StandingError {
 public:
  /// Returns the index into AttemptView::findings of the worst error that must stay on the screen; of several equally
  /// bad errors, the last one. Empty if there is none.
  std::optional<std::size_t> find(const Procedure& procedure, const AttemptView& view) const;
  void dismiss(std::size_t finding) { dismissed_.insert(finding); }
  /// Forgets which errors were dismissed, for another attempt.
  void reset() { dismissed_.clear(); }

 private:
  std::set<std::size_t> dismissed_;
};

}  // namespace insonate::train
