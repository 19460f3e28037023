#pragma once

#include <insonate/curriculum/AuditLog.h>
#include <insonate/teaching/RecomputedAttempts.h>

#include <QDialog>
#include <functional>
#include <map>
#include <string>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace insonate::ui {

class Account;
class AuditTable;
class TaskBar;

/// The administrator's window for the database of people and attempts: backup, export, verification, and the audit log.
/// Long work runs in the task bar of the main window.
class DatabaseWindow : public QDialog {
  Q_OBJECT

 public:
  DatabaseWindow(Account& account, TaskBar& tasks, QWidget* parent);

 private:
  struct Verification {
    RecomputedAttempts found;
    std::map<std::string, std::string> names;  ///< full names by Person::id
    AuditAnchor anchor;
  };
  QWidget* actions();
  QWidget* results();
  void readFacts();
  void backUp();
  void exportJson();
  void verify();
  void showVerification(const Verification& verification);
  void addResult(const QString& what, const Verification& verification, const std::string& person,
                 const std::string& attempt, const QString& details);
  /// Runs `work` in the task bar with the user's session, and passes its result to `done`; shows an error.
  template <class T>
  void run(const QString& title, std::function<Result<T>(const SignedIn&, const Progress&)> work,
           std::function<void(const T&)> done);
  void tell(const QString& words, bool isError);

  Account& account_;
  TaskBar& tasks_;
  QLabel *facts_, *message_;
  QLineEdit *earlierAnchor_, *anchor_;
  QTableWidget* differences_;
  QPushButton *backUp_, *export_, *verify_;
  AuditTable* audit_;
};

}  // namespace insonate::ui
