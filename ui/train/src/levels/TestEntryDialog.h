#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Curriculum.h>

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;

namespace insonate::train {

class TestAdmissions;

/// Dialog before a test that is not open for the user or needs a code. The user enters the code, chooses to practice,
/// or goes back. The dialog is accepted if the level shall be opened, as a test or for practice.
class TestEntryDialog final : public QDialog {
  Q_OBJECT

 public:
  TestEntryDialog(TestAdmissions& admissions, const Level& level, QWidget* parent = nullptr);

 private:
  QWidget* buildButtons();
  void refresh();
  void enter();
  void answer(const Result<void>& entered);

  TestAdmissions& admissions_;
  const Level level_;
  QLabel *words_, *said_;
  QLineEdit* code_;
  QPushButton *enter_, *practice_;
};

}  // namespace insonate::train
