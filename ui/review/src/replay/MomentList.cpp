#include "MomentList.h"

#include "../ReviewSession.h"
#include "../attempt/Words.h"
#include "LanePaint.h"

#include <insonate/ui/AttemptWords.h>

#include <QPainter>
#include <algorithm>

namespace insonate::review {
namespace {

QIcon markOf(const std::optional<Severity>& severity, double ratio) {
  return WrappedList::markIcon(ratio, [&](QPainter& painter, QPointF middle) { paintMark(painter, middle, severity); });
}

}  // namespace

MomentList::MomentList(ReviewSession& session, QWidget* parent) : WrappedList(parent), session_(session) {
  setObjectName(QStringLiteral("moments"));
  setAccessibleName(tr("Key moments"));
  setToolTip(tr("Events and errors of the attempt; a click goes to the time of an event"));
  const auto go = [this](QListWidgetItem* item) {
    session_.setPlaying(false);
    session_.setTime(item->data(Qt::UserRole).toLongLong());
  };
  connect(this, &QListWidget::itemClicked, this, go);
  connect(this, &QListWidget::itemActivated, this, [this, go](QListWidgetItem* item) {
    go(item);
    Q_EMIT entered();
  });
  connect(&session_, &ReviewSession::attemptChanged, this, [this] { fill(); });
  connect(&session_, &ReviewSession::timeChanged, this, [this] { follow(); });
}

void MomentList::fill() {
  clear();
  if (!session_.attempt()) return;
  for (const AttemptMoment& moment : session_.attempt()->moments) {
    const QString time = clockOf(moment.time_us), words = QString::fromStdString(moment.description);
    auto* item = new QListWidgetItem(markOf(moment.severity, devicePixelRatioF()),
                                     QStringLiteral("%1   %2").arg(time, words), this);
    item->setData(Qt::UserRole, qlonglong(moment.time_us));
    if (moment.severity)
      item->setData(Qt::AccessibleTextRole, tr("%1, %2: %3").arg(time, ui::nameOf(*moment.severity), words));
  }
  fitRows();
  follow();
}

void MomentList::follow() {
  if (!session_.attempt()) return;
  const auto& all = session_.attempt()->moments;
  const auto after = std::ranges::upper_bound(all, session_.time_us(), {}, &AttemptMoment::time_us);
  const int row = int(after - all.begin()) - 1;
  if (row == currentRow()) return;
  setCurrentRow(row);
  if (row >= 0) scrollToItem(item(row));
}

}  // namespace insonate::review
