#pragma once

#include <QWidget>
#include <string>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace insonate {
struct StoredAttempt;
}

namespace insonate::ui {
class Commands;
}

namespace insonate::review {

class PersonController;

/// Lists a person's attempts, newest first. Enter replays an attempt whose recording is on this computer. An instructor
/// can void an attempt, or accept an attempt without proof, and must give a reason.
class HistoryTable final : public QWidget {
  Q_OBJECT

 public:
  HistoryTable(PersonController& controller, ui::Commands& commands, QWidget* parent = nullptr);

  /// Lists only the attempts at this level (Level::name); "": all attempts.
  void showLevel(const std::string& level);

 Q_SIGNALS:
  /// Emitted when the user wants to replay the recording of an attempt of the store.
  void replayRequested(const QString& file, const QString& attempt);
  void failed(const QString& what, const QString& advice);

 private:
  QWidget* buildTable();
  QWidget* buildButtons(ui::Commands& commands);
  QWidget* buildReason();
  void show();
  void fill(int row, const StoredAttempt& attempt);
  void showChosen();
  void hideOtherLevels();
  QString hiddenWords() const;
  /// Returns the path of the recording; empty if it is not on this computer.
  QString recordingPath(const StoredAttempt& attempt) const;
  QString commentsOf(const std::string& attempt) const;
  const StoredAttempt* chosen() const;
  void replay();
  /// Change of an attempt. The user must give a reason for it.
  enum class Change { None, Void, Accept };
  void askReason(Change change);
  void wordReason(bool voids);
  void changeChosen();

  PersonController& controller_;
  QTableWidget* table_;
  QPushButton *replay_, *void_, *accept_, *earlier_, *changeNow_;
  QLabel *words_, *question_;
  QWidget* asking_;
  QLineEdit* reason_;
  Change change_ = Change::None;
  std::string level_;   ///< level of the listed attempts; empty: all
  std::string chosen_;  ///< id of the selected attempt; empty: none
};

}  // namespace insonate::review
