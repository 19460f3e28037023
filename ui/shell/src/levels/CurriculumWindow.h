#pragma once

#include <QDialog>

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QWidget;

namespace insonate::ui {

class Account;
class CurriculumController;
class LevelForm;
class LevelList;
class LevelSituationsView;

/// Window that shows published curricula, assigns them to classes, and edits and publishes drafts. For instructors and
/// administrators.
class CurriculumWindow : public QDialog {
  Q_OBJECT

 public:
  CurriculumWindow(Account& account, QWidget* parent);

  /// Closes when all changes are saved; asks the user if they cannot be saved.
  void reject() override;

 protected:
  /// Searches the cases again when the user comes back from another window, which may have opened a case.
  bool event(QEvent* event) override;

 private:
  QPushButton* button(const char* name, const QString& words, const QString& tip, void (CurriculumWindow::*act)());
  QWidget* buildShelf();
  QWidget* buildBar();
  QWidget* buildContest();
  QWidget* buildTeaching();
  void connectParts();
  void showShelf();
  void showCurriculum();
  void showLevel();
  void showSaving();
  void say(const QString& words, bool isError);
  void choose();
  void begin();
  void beginVersion();
  void discard();
  void publish();
  void askToClose();
  void teach();

  CurriculumController* controller_;
  QListWidget* shelf_;
  LevelList* levels_;
  LevelForm* form_;
  LevelSituationsView* story_;
  QWidget *contest_, *teaching_;
  QComboBox* cohort_;
  QLabel *state_, *words_;
  QPushButton *new_, *version_, *discard_, *undo_, *redo_, *publish_;
};

}  // namespace insonate::ui
