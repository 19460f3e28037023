#include "MomentList.h"

#include "../ReviewSession.h"
#include "../attempt/Words.h"
#include "LanePaint.h"

#include <insonate/ui/AttemptWords.h>

#include <QPainter>
#include <QPixmap>
#include <QSignalBlocker>
#include <algorithm>

namespace insonate::review {
namespace {

constexpr int kMark_px = 20;
/// Space of a row beside and above its text: the mark, and the padding of the style sheet.
constexpr int kBeside_px = kMark_px + 24, kAround_px = 14;

QIcon markOf(const std::optional<Severity>& severity, double ratio) {
  QPixmap pixmap(QSize(kMark_px, kMark_px) * ratio);
  pixmap.setDevicePixelRatio(ratio);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setRenderHint(QPainter::Antialiasing);
  paintMark(painter, {kMark_px / 2.0, kMark_px / 2.0}, severity);
  QIcon icon;
  // The mark keeps its color in a selected row.
  for (const QIcon::Mode mode : {QIcon::Normal, QIcon::Selected}) icon.addPixmap(pixmap, mode);
  return icon;
}

}  // namespace

MomentList::MomentList(ReviewSession& session, QWidget* parent) : QListWidget(parent), session_(session) {
  setObjectName(QStringLiteral("moments"));
  setAccessibleName(tr("Key moments"));
  setToolTip(tr("Events and errors; a click goes to the moment"));
  setWordWrap(true);
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

void MomentList::fill() {
  clear();
  if (!session_.attempt()) return;
  for (const AttemptMoment& moment : session_.attempt()->moments) {
    const QString time = clockOf(moment.time_us), words = QString::fromStdString(moment.say);
    auto* item = new QListWidgetItem(markOf(moment.severity, devicePixelRatioF()),
                                     QStringLiteral("%1   %2").arg(time, words), this);
    item->setData(Qt::UserRole, qlonglong(moment.time_us));
    if (moment.severity)
      item->setData(Qt::AccessibleTextRole, tr("%1, %2: %3").arg(time, ui::wordOf(*moment.severity), words));
  }
  fit();
  follow();
}

void MomentList::resizeEvent(QResizeEvent* event) {
  QListWidget::resizeEvent(event);
  fit();
}

/// Qt computes the height of rows without the padding of the style sheet, and would cut off texts.
void MomentList::fit() {
  const QRect room(0, 0, std::max(1, viewport()->width() - kBeside_px), QWIDGETSIZE_MAX);
  for (int row = 0; row < count(); ++row) {
    const int height = fontMetrics().boundingRect(room, Qt::TextWordWrap, item(row)->text()).height();
    item(row)->setSizeHint({room.width(), std::max(height, kMark_px) + kAround_px});
  }
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
