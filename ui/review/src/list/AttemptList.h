#pragma once

#include <insonate/procedure/AttemptHeader.h>

#include <QFutureWatcher>
#include <QString>
#include <QWidget>
#include <cstdint>
#include <string>
#include <vector>

class QAction;
class QBoxLayout;
class QLabel;
class QPushButton;
class QTableWidget;

namespace insonate::review {

struct ListedAttempt {
  QString file;
  AttemptHeader header;
  AttemptStatus status = AttemptStatus::CutShort;
  std::int64_t end_us = 0;
};

/// Returns the recordings in a folder, the latest first, including attempts that were cut short. Files that cannot be
/// read are left out. May be called on any thread; takes some milliseconds per file.
std::vector<ListedAttempt> attemptsIn(const QString& folder);

/// Lists the recordings of this computer that the user may see, the latest first. Enter or a double click opens one.
class AttemptList : public QWidget {
  Q_OBJECT

 public:
  explicit AttemptList(QWidget* parent = nullptr);
  ~AttemptList() override;

  /// Adds a button beside Open. The action belongs to the caller.
  void addOpenAction(QAction* action);
  /// Leaves out the attempts of other people (RecordedFor::person), so that trainees and guests do not see results of
  /// others. `person`: id of the user, "" for a guest; `seesAll`: the user teaches, and sees all recordings.
  void setUser(const std::string& person, bool seesAll);
  /// Reads the folder of attempts again on a background thread.
  void refresh();
  bool isReading() const { return reading_.isRunning(); }

 Q_SIGNALS:
  void chosen(const QString& file);
  void listed();

 private:
  QWidget* buildTable();
  void show();
  void choose();

  QTableWidget* table_;
  QLabel* words_;
  QPushButton* open_;
  QBoxLayout* buttons_;
  QFutureWatcher<std::vector<ListedAttempt>> reading_;
  std::vector<ListedAttempt> all_;
  std::string person_;
  bool seesAll_ = false;
};

}  // namespace insonate::review
