#pragma once

#include <QWidget>

class QMenu;
class QPushButton;
class QTableView;

namespace insonate::ui {
class Commands;
class ValueSlider;
}  // namespace insonate::ui

namespace insonate::prepare {

struct PrepareModel;
class StructureModel;

/// The table of structures, with commands for the selected structure. Space shows or hides the structure, Enter chooses
/// a color (unless a tool is selected), and F2 renames one of the author's own structures. A wide table also shows
/// tissue, term and number of voxels.
class StructureTable : public QWidget {
 public:
  StructureTable(PrepareModel& shared, const ui::Commands& commands);

  /// Lets the user choose a color for the selected structure.
  void chooseColor();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void buildTable();
  void showColumns();
  /// Begins to edit the selected structure's name.
  void rename();
  QWidget* buildButtons();
  void clicked(const QModelIndex& index);
  void fillAdd(QMenu& menu);
  void showSelected();

  PrepareModel& shared_;
  const ui::Commands& commands_;
  StructureModel* model_;
  QTableView* table_;
  ui::ValueSlider *opacity_, *onSlices_;
  QPushButton *only_ = nullptr, *all_ = nullptr, *remove_ = nullptr;
  bool showing_ = false;
};

}  // namespace insonate::prepare
