#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace insonate {
struct KeptAttempt;
}

namespace insonate::review {

class PersonDesk;

/// A person's attempts, newest first: Enter replays one whose recording is here, and an instructor takes one out of the
/// count, or counts one that nothing proves, with a reason.
class HistoryTable final : public QWidget {
  Q_OBJECT

 public:
  explicit HistoryTable(PersonDesk& desk, QWidget* parent = nullptr);

 Q_SIGNALS:
  /// The user wants to replay the recording of an attempt in the store.
  void replayWanted(const QString& file, const QString& attempt);
  void failed(const QString& what, const QString& advice);

 private:
  QWidget* buildTable();
  QWidget* buildButtons();
  QWidget* buildReason();
  void show();
  void fill(int row, const KeptAttempt& attempt);
  void showChosen();
  /// File of the recording; empty if it is not on this computer.
  QString recordingOf(const KeptAttempt& attempt) const;
  const KeptAttempt* chosen() const;
  void replay();
  /// Change for which a reason is asked.
  enum class Change { None, Void, Accept };
  void askReason(Change change);
  void wordReason(bool voids);
  void changeChosen();

  PersonDesk& desk_;
  QTableWidget* table_;
  QPushButton *replay_, *void_, *accept_, *earlier_, *changeNow_;
  QLabel *words_, *question_;
  QWidget* asking_;
  QLineEdit* reason_;
  Change change_ = Change::None;
};

}  // namespace insonate::review
