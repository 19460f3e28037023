#pragma once

#include <QWidget>

class QAction;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace insonate::prepare {

class PrepareSession;
class StructureTable;

/// The way of a case: import, label, check; with the table of structures, and what keeps the changes.
class PathPanel : public QWidget {
  Q_OBJECT

 public:
  explicit PathPanel(PrepareSession& session, QWidget* parent = nullptr);

  void setCaseActions(QAction* open, QAction* import, QAction* reload);
  void setEditActions(QAction* undo, QAction* redo, QAction* save);
  StructureTable& table() { return *table_; }

 Q_SIGNALS:
  void checkChosen();

 private:
  QWidget* step(const QString& title, QLabel*& mark);
  QToolButton* button(QAction* action, bool withText);
  void refresh();

  PrepareSession& session_;
  QLabel *importMark_ = nullptr, *labelMark_ = nullptr, *checkMark_ = nullptr;
  QHBoxLayout *caseRow_, *editRow_;
  StructureTable* table_;
  QPushButton* check_;
};

}  // namespace insonate::prepare
