#pragma once

#include <QWidget>

class QAction;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace insonate::prepare {

class LabelPages;

/// One step of the path from import to publication: a heading with a mark of the step's progress, and the features'
/// controls.
class PathStep : public QWidget {
 public:
  explicit PathStep(const QString& title);

  /// Adds controls below the earlier controls; `stretch` as in QBoxLayout.
  void add(QWidget* controls, int stretch = 0);
  /// Shows the step's progress in a few words.
  void setMark(const QString& mark);
  void setNumber(int number);
  /// Tells whether no feature has added controls.
  bool isEmpty() const;

 private:
  QString title_;
  QLabel *heading_, *mark_;
  QVBoxLayout* box_;
};

/// The left column: the steps of preparing a case (import, label, check, publish), and buttons for the case below the
/// steps.
class PathColumn : public QWidget {
 public:
  PathColumn();

  PathStep& import() { return *import_; }
  PathStep& label() { return *label_; }
  PathStep& check() { return *check_; }
  PathStep& publish() { return *publish_; }
  /// The pages of the label step.
  LabelPages& labelPages() { return *labelPages_; }
  /// Adds a widget below the steps.
  void addFoot(QWidget* foot);
  /// Numbers the steps, and hides those without controls.
  void assemble();

 private:
  PathStep *import_, *label_, *check_, *publish_;
  LabelPages* labelPages_;
  QVBoxLayout* box_;
};

/// Makes the button of an action.
QToolButton* actionButton(QAction* action, Qt::ToolButtonStyle style);

}  // namespace insonate::prepare
