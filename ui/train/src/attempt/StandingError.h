#pragma once

#include <cstddef>
#include <optional>
#include <set>

namespace insonate {
struct AttemptView;
struct Procedure;
}  // namespace insonate

namespace insonate::train {

/// The major or critical error of an attempt that stays in sight until it is dealt with: until the needle has left the
/// skin after it, or the trainee dismisses it.
class StandingError {
 public:
  /// Returns the index into AttemptView::findings of the worst error that is not dealt with, of equal ones the last;
  /// empty: there is none.
  std::optional<std::size_t> find(const Procedure& procedure, const AttemptView& view) const;
  void dismiss(std::size_t finding) { dismissed_.insert(finding); }
  /// Begins another attempt.
  void reset() { dismissed_.clear(); }

 private:
  std::set<std::size_t> dismissed_;
};

}  // namespace insonate::train
