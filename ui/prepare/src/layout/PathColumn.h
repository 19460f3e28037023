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
  Q_OBJECT

 public:
  enum class State { Open, Done, Unknown };

  explicit PathStep(const QString& title);

  /// Adds controls below the earlier controls; `stretch` as in QBoxLayout.
  void add(QWidget* controls, int stretch = 0);
  /// Shows the step's progress in a few words.
  void setMark(const QString& mark, State state);
  State state() const { return state_; }
  /// Marks the step as the one to do next, or removes this mark.
  void setNext(bool isNext);
  void setNumber(int number);
  /// Tells whether no feature has added controls.
  bool isEmpty() const;

 Q_SIGNALS:
  void stateChanged();

 private:
  QString title_;
  State state_ = State::Unknown;
  QLabel *heading_, *next_, *mark_;
  QVBoxLayout* box_;
};

/// The left column: the steps of preparing a case (import, label, check, publish), of which the first open one is
/// marked as next, and buttons for the case below the steps.
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
  void showNext();

  PathStep *import_, *label_, *check_, *publish_;
  LabelPages* labelPages_;
  QVBoxLayout* box_;
};

/// Makes the button of an action.
QToolButton* actionButton(QAction* action, Qt::ToolButtonStyle style);

}  // namespace insonate::prepare
