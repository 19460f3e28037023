#pragma once

#include <insonate/curriculum/Curriculum.h>

#include <QWidget>

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace insonate::train {

class Course;
class LevelControl;
class TestAdmissions;

/// Lists the levels: open, mastered, lapsed, or locked with the reason, and each level's rule. The user can practice
/// each level that is not locked.
class PathPage final : public QWidget {
  Q_OBJECT

 public:
  PathPage(Course& course, LevelControl& levels, TestAdmissions& admissions, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// Emitted when the user has chosen a level to practice; the window then shows the image.
  void chosen();

 private:
  QWidget* buildList();
  QWidget* buildLevel();
  void refresh();
  void refreshHead();
  void refreshList();
  void refreshLevel();
  const Level* selected() const;
  void practise();
  void begin(const std::string& level);

  Course& course_;
  LevelControl& levels_;
  TestAdmissions& admissions_;
  QLabel *head_ = nullptr, *note_ = nullptr;
  QComboBox* choice_ = nullptr;
  QListWidget* list_ = nullptr;
  QWidget* level_ = nullptr;
  QLabel *title_ = nullptr, *about_ = nullptr, *why_ = nullptr, *setting_ = nullptr, *pass_ = nullptr,
         *standards_ = nullptr, *mastery_ = nullptr, *test_ = nullptr;
  QPushButton *practise_ = nullptr, *free_ = nullptr;
};

}  // namespace insonate::train
