#include "LibraryCard.h"

#include "LibraryModel.h"

#include <insonate/ui/StateColors.h>
#include <insonate/ui/Theme.h>

#include <QPainter>

namespace insonate::ui {
namespace {

namespace theme = views::theme;

constexpr int kPicture_px = 92, kHeight_px = kPicture_px + 2 * kGap, kSign_px = 16;

void drawPicture(QPainter& painter, const QImage& image, const QRect& room) {
  painter.fillRect(room, toQColor(theme::kBlack));
  if (image.isNull()) return;
  const QSize size = image.size().scaled(room.size(), Qt::KeepAspectRatio);
  QRect place(QPoint(), size);
  place.moveCenter(room.center());
  painter.drawImage(place, image);
}

struct Sign {
  const char* icon;
  CheckState state;
  QString words;
};

Sign needleSymbol(const LibraryEntry& entry) {
  if (entry.state == LibraryEntry::State::Broken)
    return {"close", CheckState::Failed, LibraryCard::tr("case cannot be opened")};
  if (entry.state == LibraryEntry::State::Waiting) return {"", CheckState::Unknown, LibraryCard::tr("reading ...")};
  if (!entry.fit) return {"close", CheckState::Failed, LibraryCard::tr("not fit for training")};
  if (!entry.warnings.isEmpty())
    return {"warning", CheckState::Warnings,
            entry.warnings.size() == 1 ? LibraryCard::tr("fit for training, 1 warning")
                                       : LibraryCard::tr("fit for training, %1 warnings").arg(entry.warnings.size())};
  return {"done", CheckState::Passed, LibraryCard::tr("fit for training")};
}

QString secondLine(const LibraryEntry& entry) {
  if (entry.state == LibraryEntry::State::Broken) return entry.error;
  if (entry.state == LibraryEntry::State::Waiting) return entry.description;
  if (!entry.fit && !entry.errors.isEmpty()) return entry.errors.first();
  return entry.reason;
}

QString gradeText(const LibraryEntry& entry) {
  if (entry.grade.isEmpty())
    return entry.state == LibraryEntry::State::Known ? LibraryCard::tr("not graded") : QString();
  return entry.graded ? entry.grade : LibraryCard::tr("%1 (estimated)").arg(entry.grade);
}

QString originText(const LibraryEntry& entry) {
  if (entry.builtIn) return LibraryCard::tr("built in");
  if (entry.version == 0) return LibraryCard::tr("no version");
  return LibraryCard::tr("version %1   %2").arg(entry.version).arg(entry.date);
}

}  // namespace

LibraryCard::LibraryCard(const LibraryFilter& cases, QObject* parent) : QStyledItemDelegate(parent), cases_(cases) {}

QSize LibraryCard::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
  return {2 * kPicture_px + 300, kHeight_px};
}

void LibraryCard::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const LibraryEntry& entry = cases_.entry(index);
  painter->save();
  painter->setRenderHint(QPainter::SmoothPixmapTransform);
  const bool chosen = option.state & QStyle::State_Selected;
  painter->fillRect(option.rect, toQColor(chosen ? theme::kRaised : theme::kPanel));
  if (chosen) painter->fillRect(QRect(option.rect.topLeft(), QSize(3, option.rect.height())), toQColor(theme::kAccent));
  painter->fillRect(QRect(option.rect.bottomLeft(), QSize(option.rect.width(), 1)), toQColor(theme::kLine));
  QRect inner = option.rect.adjusted(kLargeGap, kGap, -kLargeGap, -kGap);
  const QRect slice(inner.topLeft(), QSize(kPicture_px, kPicture_px));
  drawPicture(*painter, entry.slice, slice);
  drawPicture(*painter, entry.ultrasound, slice.translated(kPicture_px + kSmallGap, 0));
  inner.setLeft(inner.left() + 2 * kPicture_px + kSmallGap + kLargeGap);

  QFont bold = option.font;
  bold.setWeight(QFont::DemiBold);
  const int line = option.fontMetrics.height() + kSmallGap;
  const Sign sign = needleSymbol(entry);
  const int aside = option.fontMetrics.horizontalAdvance(LibraryCard::tr("fit for training, %1 warnings").arg(99)) +
                    kSign_px + kLargeGap;
  QRect right(inner.right() - aside, inner.top(), aside, line);
  QRect text(inner.left(), inner.top(), inner.width() - aside - kGap, line);
  const auto write = [&](const QRect& where, const QString& words, views::Color ink) {
    painter->setPen(toQColor(ink));
    painter->drawText(where, Qt::AlignLeft | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(words, Qt::ElideRight, where.width()));
  };
  painter->setFont(bold);
  write(text, entry.title, theme::kText);
  painter->setFont(option.font);
  write(text.translated(0, line), gradeText(entry), theme::kText);
  // Two lines, broken at the end of a word.
  painter->setPen(toQColor(entry.state == LibraryEntry::State::Broken ? theme::kText : theme::kQuiet));
  const QRect reason(inner.left(), inner.top() + 2 * line, inner.width() - aside - kGap, inner.height() - 2 * line);
  painter->drawText(reason, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, secondLine(entry));
  if (*sign.icon)
    icon(QLatin1String(sign.icon), colorOf(sign.state)).paint(painter, right.left(), right.top(), kSign_px, line);
  write(right.adjusted(kSign_px + kSmallGap, 0, 0, 0), sign.words, theme::kText);
  write(right.translated(0, line).adjusted(kSign_px + kSmallGap, 0, 0, 0), originText(entry), theme::kQuiet);
  if (option.state & QStyle::State_HasFocus && chosen) {
    painter->setPen(toQColor(theme::kAccent));
    painter->drawRect(option.rect.adjusted(0, 0, -1, -1));
  }
  painter->restore();
}

}  // namespace insonate::ui
