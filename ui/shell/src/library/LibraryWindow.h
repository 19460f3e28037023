#pragma once

#include "LibraryEntry.h"

#include <QDialog>
#include <atomic>
#include <memory>
#include <vector>

class QComboBox;
class QLabel;
class QLineEdit;
class QListView;
class QPushButton;

namespace insonate::ui {

class LibraryFilter;
class LibraryModel;

/// Shows all available cases with contents and difficulty: the cases in the folders that the user has added, and the
/// built-in necks. While the window is open, a background thread reads the cases one after the other.
class LibraryWindow final : public QDialog {
  Q_OBJECT

 public:
  /// `workspace`, "train" or "prepare": where Enter and a double click open a case; Ctrl+Enter opens it in the other.
  explicit LibraryWindow(QWidget* parent, const QString& workspace = QStringLiteral("train"));
  ~LibraryWindow() override;

  /// Tells whether all cases have been read.
  bool isDone() const { return done_; }

 Q_SIGNALS:
  /// Emitted when the user opens a case. `place`: a folder or the name of a built-in neck; `workspace`: "train" or
  /// "prepare".
  void caseChosen(const QString& place, const QString& workspace);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void arrange();
  void connectAll();
  void look();
  void take(std::vector<LibraryEntry> listed);
  void showState();
  void addFolder();
  void removeFolder();
  void openChosen(const QString& workspace);
  const LibraryEntry* chosen() const;
  void setFolders(const QStringList& folders);

  QString workspace_, other_;
  LibraryModel* model_;
  LibraryFilter* filter_;
  QLineEdit* search_;
  QComboBox *grade_, *fitness_, *order_;
  QListView* list_;
  QLabel *state_, *empty_;
  QPushButton *train_, *prepare_, *add_, *remove_;
  std::shared_ptr<std::atomic<bool>> stopped_;  ///< stops the present run of the reading thread
  int left_ = 0;                                ///< number of cases that are not read yet
  bool done_ = false;
};

}  // namespace insonate::ui
