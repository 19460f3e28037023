#pragma once

#include "WrappedList.h"

namespace insonate::review {

class ReviewSession;

/// Lists the important moments, with the same marks as on the timeline. A click moves the time to a moment. The last
/// moment before the present time is the current row.
class MomentList : public WrappedList {
  Q_OBJECT

 public:
  explicit MomentList(ReviewSession& session, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Emitted after Enter or a double click, when the user also wants to see the moment's image.
  void entered();

 private:
  void fill();
  void follow();

  ReviewSession& session_;
};

}  // namespace insonate::review
