#pragma once

#include <QWidget>

class QMenu;
class QPushButton;
class QTableView;

namespace insonate::ui {
class ValueSlider;
}

namespace insonate::prepare {

struct PrepareModel;
class StructureModel;

/// The table of structures with the commands for one of them. Space shows or hides, Enter chooses a color (unless a
/// tool is in hand), F2 names one of the author's own. A wide table also shows tissue, term and voxels.
class StructureTable : public QWidget {
 public:
  explicit StructureTable(PrepareModel& shared, QWidget* parent = nullptr);

  /// Asks for a color of the selected structure.
  void chooseColour();
  /// Enter is a tool's while one is in hand: who chooses its label here wants to apply it.
  void setToolInHand(bool inHand) { toolInHand_ = inHand; }

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
  StructureModel* model_;
  QTableView* table_;
  ui::ValueSlider *opacity_, *onSlices_;
  QPushButton *only_ = nullptr, *all_ = nullptr, *remove_ = nullptr;
  bool showing_ = false, toolInHand_ = false;
};

}  // namespace insonate::prepare
