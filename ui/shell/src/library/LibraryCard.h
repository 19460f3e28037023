#pragma once

#include <QStyledItemDelegate>

namespace insonate::ui {

class LibraryFilter;

/// Paints one case as a row: CT and ultrasound, title, grade and its reason, version, and whether the case is fit for
/// training.
class LibraryCard final : public QStyledItemDelegate {
 public:
  LibraryCard(const LibraryFilter& cases, QObject* parent);
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

 private:
  const LibraryFilter& cases_;
};

}  // namespace insonate::ui
