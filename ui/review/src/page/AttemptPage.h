#pragma once

#include <QWidget>

class QButtonGroup;
class QHBoxLayout;
class QLabel;
class QSettings;
class QSplitter;
class QStackedWidget;
class QToolButton;
class QVBoxLayout;

namespace insonate::ui {
class Commands;
}

namespace insonate::review {

struct ReviewModel;

/// Layout of the page of an open attempt, which the features fill: a bar with title, tabs and buttons, a notice, three
/// columns, and widgets below the columns. The right column shows 3D and the widgets below it. The forms of raters are
/// shown in place of the right column, with the whole height below the notice.
class AttemptPage final : public QWidget {
  Q_OBJECT

 public:
  explicit AttemptPage(const ReviewModel& model);

  /// Adds a tab that shows `widget` in the center. The command with the id `command` must exist; the tab gets its
  /// tooltip.
  void addCenter(const QString& command, const char* object, const QString& text, QWidget* widget);
  void showCenter(QWidget* widget);
  bool showsCenter(const QWidget* widget) const;
  /// Adds a button that shows and hides something. `command` as for addCenter().
  QToolButton* addToggle(const QString& command, const char* object, const QString& text);
  /// Adds a button at the right end of the bar.
  void addButton(QWidget* button);
  /// Adds a widget at the lower end of the left column.
  void addLeft(QWidget* widget);
  /// Adds a widget at the lower end of the right column.
  void addBelow(QWidget* widget);
  /// Sets the widget that showForms() shows in place of the right column.
  void setForms(QWidget* forms);
  void showForms(bool shown);
  /// Adds a widget below the columns.
  void addFoot(QWidget* widget);
  /// Shows a text below the bar; empty: none.
  void setNotice(const QString& text);
  /// Sets the name of the trainee whose attempt is shown; empty: unknown.
  void setTrainee(const QString& name);

  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  void centerChanged();

 private:
  QWidget* buildBar();
  QWidget* buildColumns();
  void showFacts();

  const ReviewModel& model_;
  QLabel *title_, *date_, *facts_, *notice_;
  QString trainee_;
  QHBoxLayout *tabRow_, *toggleRow_, *buttonRow_;
  QButtonGroup* tabs_;
  QSplitter *body_, *columns_, *leftColumn_, *rightColumn_;
  QStackedWidget* center_;
  QWidget* forms_ = nullptr;
  QVBoxLayout* main_;  ///< columns, and the widgets below them
};

}  // namespace insonate::review
