#include "MomentList.h"

#include "../ReviewSession.h"
#include "../attempt/Words.h"
#include "LanePaint.h"

#include <QPainter>
#include <QPixmap>
#include <QSignalBlocker>
#include <algorithm>

namespace insonate::review {
namespace {

constexpr int kMark_px = 20;

QIcon markOf(const std::optional<Severity>& severity, double ratio) {
  QPixmap pixmap(QSize(kMark_px, kMark_px) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintMark(painter, {kMark_px / 2.0, kMark_px / 2.0}, severity);
  QIcon icon;
  // The mark keeps its colour where its row is chosen.
  for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) icon.addPixmap(pixmap, mode);
  return icon;
}

}  // namespace

MomentList::MomentList(ReviewSession& session, QWidget* parent) : QListWidget(parent), session_(session) {
  setObjectName(QStringLiteral("moments"));
  setAccessibleName(tr("Moments that mattered"));
  setToolTip(tr("What happened, and what went wrong; a click goes there"));
  setWordWrap(true);
  setTextElideMode(Qt::ElideNone);
  setIconSize({kMark_px, kMark_px});
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setResizeMode(QListView::Adjust);
  setUniformItemSizes(false);
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

/// Words wrap anew, also where a scroll bar has come.
void MomentList::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  scheduleDelayedItemsLayout();
}

void MomentList::fill() {
  clear();
  if (!session_.attempt()) return;
  for (const AttemptMoment& moment : session_.attempt()->moments) {
    const QString time = clockOf(moment.time_us), words = QString::fromStdString(moment.say);
    auto* item = new QListWidgetItem(markOf(moment.severity, devicePixelRatioF()),
                                     QStringLiteral("%1   %2").arg(time, words), this);
    item->setData(Qt::UserRole, qlonglong(moment.time_us));
    if (moment.severity)
      item->setData(Qt::AccessibleTextRole, tr("%1, %2: %3").arg(time, wordsOf(*moment.severity), words));
  }
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
