#pragma once

#include <QWidget>

class QAction;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;
class QTabBar;
class QToolButton;

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

class GuideSession;
struct PrepareModel;
class StructureTable;

/// Shows the steps of a case: import, label, check, publish; with the guide or the table of structures, and buttons for
/// undo, redo and save.
class PathPanel : public QWidget {
  Q_OBJECT

 public:
  PathPanel(PrepareModel& shared, GuideSession& guide, ui::TaskBar& tasks, QWidget* parent = nullptr);

  void setCaseActions(QAction* open, QAction* import, QAction* reload);
  void setEditActions(QAction* undo, QAction* redo, QAction* save);
  StructureTable& table() { return *table_; }
  /// Shows the guide, or the table of structures.
  void showGuide(bool guide);

 Q_SIGNALS:
  void checkChosen();

 private:
  QWidget* buildLabelling();
  void chooseLabelling();
  QWidget* step(const QString& title, QLabel*& mark);
  QToolButton* button(QAction* action, bool withText);
  void refresh();

  PrepareModel& shared_;
  GuideSession& guide_;
  QLabel *importMark_ = nullptr, *labelMark_ = nullptr, *checkMark_ = nullptr, *publishMark_ = nullptr;
  QHBoxLayout *caseRow_, *editRow_;
  StructureTable* table_;
  QTabBar* tabs_;
  QStackedWidget* labelling_;
  bool chosen_ = true;  ///< guide or table has been selected for this case
  QPushButton* check_;
};

}  // namespace insonate::prepare
