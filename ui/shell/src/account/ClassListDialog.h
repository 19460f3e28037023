#pragma once

#include <insonate/curriculum/ClassImport.h>
#include <insonate/curriculum/Person.h>

#include <QDialog>
#include <QString>
#include <QTimer>
#include <atomic>
#include <memory>
#include <vector>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace insonate::ui {

class Account;

/// Imports a class list (CSV). The dialog first shows what the import would do with each line, and then imports all
/// lines or none. It shows the first passwords only once, for saving or printing.
class ClassListDialog : public QDialog {
  Q_OBJECT

 public:
  ClassListDialog(Account& account, Cohort cohort, QWidget* parent);
  ~ClassListDialog() override;

  /// Reads a file and shows what the import would do with its lines.
  void open(const QString& file);
  using QDialog::open;

  void reject() override;

 Q_SIGNALS:
  void imported();  ///< emitted when people were added to the class

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  /// Progress and cancellation, shared with the account's thread.
  struct Work {
    std::atomic<double> done = 0;
    std::atomic<bool> stopped = false;
  };
  QPushButton* button(const char* name, const QString& words, const QString& tip, void (ClassListDialog::*act)());
  void choose();
  void takePlan(Result<std::vector<ClassImportRow>> plan);
  void showRows();
  void apply();
  void takeOutcome(const Result<void>& outcome);
  void savePasswords();
  void printPasswords();
  void say(const QString& words, bool isError);
  bool isWorking() const { return work_ != nullptr; }

  Account& account_;
  const Cohort cohort_;
  QString path_;  ///< path of the class list
  std::vector<ClassImportRow> plan_;
  std::vector<FirstPassword> passwords_;  ///< passwords of the people who were added
  bool handedOut_ = false;                ///< true: the passwords were saved or printed
  int round_ = 0;                         ///< number of the last chosen file; results about earlier files are dropped
  std::shared_ptr<Work> work_;
  QTimer looking_;
  QLabel *file_, *words_;
  QTableWidget* table_;
  QProgressBar* bar_;
  QPushButton *choose_, *go_, *save_, *print_, *close_;
};

}  // namespace insonate::ui
