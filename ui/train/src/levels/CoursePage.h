#pragma once

#include <QWidget>

class QButtonGroup;
class QStackedWidget;

namespace insonate::ui {
class Account;
}

namespace insonate::train {

class Course;
class LevelControl;
class TestAdmissions;

/// The page in place of image and controls: the learning path of levels, the user's attempts with a learning curve, and
/// the questionnaire.
class CoursePage final : public QWidget {
  Q_OBJECT

 public:
  enum Tab { Levels, Attempts, Questionnaire };

  /// `leavingKeys`: keys of the command that returns to the image, besides Esc.
  CoursePage(Course& course, LevelControl& levels, TestAdmissions& admissions, ui::Account* account,
             const QString& leavingKeys, QWidget* parent = nullptr);

  void showTab(Tab tab);
  /// Gives the keyboard focus to the list of the current tab.
  void takeKeyboard();

 Q_SIGNALS:
  /// Emitted when the user wants to return to the image.
  void left();
  void attemptRequested(const QString& file);
  void messageReported(const QString& sentence);
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice);

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  QWidget* buildHead(const QString& leavingKeys);

  QButtonGroup* tabs_;
  QStackedWidget* pages_;
};

}  // namespace insonate::train
