#pragma once

#include "CurriculumShelf.h"
#include "EntryDialog.h"

#include <insonate/curriculum/CohortStore.h>

#include <QDialog>
#include <functional>
#include <vector>

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace insonate::ui {

class Account;

/// Lists people with their classes and roles: all people for administrators, the people of their classes for
/// instructors. Changes are written to the store at once; the window then shows the store's state.
class PeopleWindow : public QDialog {
  Q_OBJECT

 public:
  PeopleWindow(Account& account, QWidget* parent);

 Q_SIGNALS:
  /// Emitted when the user has changed people or classes in this window.
  void changed();

 private:
  struct Shown {
    Person person;
    bool teaches = false;
  };
  QWidget* classColumn();
  QWidget* peopleColumn();
  QPushButton* button(const char* name, const QString& words, const QString& tip, void (PeopleWindow::*act)());
  void read();
  void readPeople();
  void showCurricula();
  void showPeople(std::vector<Shown> people);
  void refresh();
  EntryDialog::Action asking(std::function<Result<void>(const SignedIn&, const QStringList&)> what);
  void change(std::function<Result<void>(const SignedIn&)> what);
  void tell(const QString& words);

  const Cohort* cohort() const;  ///< the selected class; null: all people
  const Shown* chosen() const;   ///< the selected person; null: none
  bool isAdministrator() const;

  void setCurriculum();
  void addClass();
  void renameClass();
  void archiveClass();
  void deleteClass();
  void addPerson();
  void showFirstPassword(const QString& name, const QString& password);
  void importList();
  void editPerson();
  void setPassword();
  void toggleDisabled();
  void join();
  void leave();
  void editLevels();

  Account& account_;
  struct Read {
    std::vector<Cohort> cohorts;
    std::vector<OfferedCurriculum> curricula;
  };
  static Result<Read> readFrom(const SignedIn& by);

  std::vector<Cohort> cohorts_;
  std::vector<OfferedCurriculum> curricula_;
  std::vector<Shown> people_;
  QString newClass_;  ///< name of the class that was just added; selected when the store has it
  QListWidget* classes_;
  QTableWidget* table_;
  QComboBox* curriculum_;
  QComboBox* target_;  ///< the class that the person joins
  QComboBox* as_;      ///< role in which the person joins the class
  QLabel* error_;
  QPushButton *addClass_, *renameClass_, *archive_, *delete_, *add_, *import_, *edit_, *password_, *disable_, *join_,
      *leave_;
};

}  // namespace insonate::ui
