#include "CommentList.h"

#include "../ReviewSession.h"
#include "../attempt/Words.h"
#include "../replay/LanePaint.h"

#include <insonate/ui/AttemptWords.h>
#include <insonate/ui/PlainToolTip.h>
#include <insonate/ui/Text.h>

#include <algorithm>

namespace insonate::review {

CommentList::CommentList(ReviewSession& session, QWidget* parent) : WrappedList(parent), session_(session) {
  setObjectName(QStringLiteral("comments"));
  setAccessibleName(tr("Comments"));
  setToolTip(tr("Comments on the replay; a click goes to the comment's time"));
  const auto go = [this](QListWidgetItem* item) { goTo(comments_[std::size_t(row(item))].at_us); };
  connect(this, &QListWidget::itemClicked, this, go);
  connect(this, &QListWidget::itemActivated, this, go);
  connect(&session_, &ReviewSession::timeChanged, this, [this] { follow(); });
}

void CommentList::show(const std::vector<AttemptComment>& comments) {
  if (comments == comments_) return;
  clear();
  comments_ = comments;
  for (const AttemptComment& one : comments_) {
    const QString time = clockOf(one.at_us), text = ui::qt(one.text);
    const QString by = tr("%1, %2").arg(ui::qt(one.author), ui::dayAndTimeOf(one.written_us));
    const QString words = QStringLiteral("%1   %2\n%3").arg(time, text, one.isRead ? by : tr("%1, unread").arg(by));
    const QIcon icon = markIcon(devicePixelRatioF(),
                                [&](QPainter& painter, QPointF middle) { paintComment(painter, middle, !one.isRead); });
    auto* item = new QListWidgetItem(icon, words, this);
    item->setToolTip(ui::plainToolTip(text));
  }
  fitRows();
  follow();
}

const AttemptComment* CommentList::chosen() const {
  const int row = currentRow();
  return row < 0 || row >= int(comments_.size()) ? nullptr : &comments_[std::size_t(row)];
}

void CommentList::goTo(std::int64_t at_us) {
  session_.setPlaying(false);
  session_.setTime(at_us);
}

void CommentList::step(int by) {
  const std::int64_t now_us = session_.time_us();
  if (by > 0) {
    const auto next = std::ranges::upper_bound(comments_, now_us, {}, &AttemptComment::at_us);
    if (next != comments_.end()) goTo(next->at_us);
  } else if (const auto at = std::ranges::lower_bound(comments_, now_us, {}, &AttemptComment::at_us);
             at != comments_.begin()) {
    goTo(std::prev(at)->at_us);
  }
}

/// Keeps the row if several comments are at the present time.
void CommentList::follow() {
  if (const AttemptComment* now = chosen(); now && now->at_us == session_.time_us()) return;
  const auto after = std::ranges::upper_bound(comments_, session_.time_us(), {}, &AttemptComment::at_us);
  const int row = int(after - comments_.begin()) - 1;
  if (row == currentRow()) return;
  setCurrentRow(row);
  if (row >= 0) scrollToItem(item(row));
}

}  // namespace insonate::review
