#pragma once

#include "../replay/WrappedList.h"

#include <insonate/curriculum/CommentStore.h>

#include <vector>

namespace insonate::review {

class ReviewSession;

/// Lists comments, with the same marks as on the timeline. A click moves the time to a comment. The last comment before
/// the present time is the current row.
class CommentList final : public WrappedList {
  Q_OBJECT

 public:
  explicit CommentList(ReviewSession& session, QWidget* parent = nullptr);

  void show(const std::vector<AttemptComment>& comments);
  /// The current row's comment; null if there is none.
  const AttemptComment* chosen() const;
  /// Moves the time to the next or previous comment; no effect if there is none.
  void step(int by);

 private:
  void follow();
  void goTo(std::int64_t at_us);

  ReviewSession& session_;
  std::vector<AttemptComment> comments_;
};

}  // namespace insonate::review
