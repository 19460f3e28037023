#pragma once

#include <QTableView>

namespace insonate::review {

/// The first column of a table, drawn over the table so that it stays visible when the table is scrolled to the right.
/// Shares the table's model and selection.
class NameColumn final : public QTableView {
  Q_OBJECT

 public:
  /// `table` has its model and its columns' widths, and becomes the parent.
  explicit NameColumn(QTableView& table);

 protected:
  /// Follows the size of the table.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void buildHeader();
  void place();

  QTableView& table_;
};

}  // namespace insonate::review
