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

/// All available cases: those of the folders that the user has chosen, and the built-in necks, with contents and
/// difficulty. A thread reads them one after the other while the window is open.
class LibraryWindow final : public QDialog {
  Q_OBJECT

 public:
  explicit LibraryWindow(QWidget* parent);
  ~LibraryWindow() override;

  /// Tells whether all cases have been read.
  bool isDone() const { return done_; }

 Q_SIGNALS:
  /// A folder or the name of a built-in neck, and the workspace to open it in: "train" or "prepare".
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
  void open(const QString& workspace);
  const LibraryEntry* chosen() const;
  static QStringList folders();
  void setFolders(const QStringList& folders);

  LibraryModel* model_;
  LibraryFilter* filter_;
  QLineEdit* search_;
  QComboBox *grade_, *fitness_, *order_;
  QListView* list_;
  QLabel *state_, *empty_;
  QPushButton *train_, *prepare_, *add_, *remove_;
  std::shared_ptr<std::atomic<bool>> stopped_;  ///< of the look that is under way
  int left_ = 0;                                ///< cases that are not looked at yet
  bool done_ = false;
};

}  // namespace insonate::ui
