#pragma once

#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/Workspace.h>

#include <QMainWindow>
#include <functional>
#include <memory>
#include <vector>

class QAction;
class QMenu;
class QStackedWidget;

namespace insonate::ui {

class Account;
class AccountMenu;
class CaseExchange;
class ErrorPanel;
class HeaderBar;
class HelpWindow;
class SiteExchange;
class StatusStrip;
class TaskBar;
struct Loss;
enum class LostBy;

/// The main window: shows one workspace, the open case, running jobs and errors. Stores its position, the workspace and
/// recent cases in the user's settings (QSettings of the application). Opens a dropped case folder, DICOM folder,
/// volume file or recorded attempt.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// Opens the store of people at its default address.
  MainWindow();
  explicit MainWindow(std::unique_ptr<Account> account);
  ~MainWindow() override;

  /// Adds a workspace, which the window then owns. `id` names it in settings and on the command line. Add all before
  /// showing the window.
  void addWorkspace(const QString& id, const QString& title, const QString& iconName, Workspace* workspace);
  /// Shows a workspace; false if there is none with this id.
  bool showWorkspace(const QString& id);
  Workspace* currentWorkspace() const;
  QString currentId() const;

  /// Asks who trains on this computer if the program is started for the first time; not for scripts.
  void askAtFirstStart();
  /// Restores the layout of the last session.
  void restoreLayout();

  /// Opens a case folder, a DICOM folder, a volume file or a recorded attempt. This and the functions below ask first
  /// if an unsaved case, edits or work would be lost.
  void open(const QString& path);
  void openTextbook();
  /// Shows the library of all available cases.
  void showLibrary();
  /// Opens a built-in neck by its name.
  void openBuiltIn(const QString& variant);
  /// Opens a recorded attempt in the workspace that shows attempts, and shows that workspace.
  void openAttempt(const QString& file);
  /// Rereads the case from its folder; no effect for a case that is not on disk.
  void reload();
  /// Writes the case with all edits to its folder; asks for a folder if it has none.
  void saveCase();
  const LoadedCase& current() const { return case_; }

  /// Tells whether a case is open, no job is running, and the workspace is ready.
  bool isReady() const;
  /// Tells whether no further results will arrive.
  bool isComplete() const;

  QAction* openAction() const { return open_; }
  QAction* importAction() const { return import_; }
  QAction* textbookAction() const { return textbook_; }
  QAction* libraryAction() const { return library_; }
  QAction* attemptAction() const { return attempt_; }
  QAction* reloadAction() const { return reload_; }
  QAction* saveAction() const { return save_; }
  Account& account() { return *account_; }
  TaskBar& tasks() { return *tasks_; }
  ErrorPanel& errors() { return *errors_; }
  QString statusText() const;
  QString caseTitle() const;
  /// Closes without asking about unsaved changes.
  void closeAtOnce();

 Q_SIGNALS:
  void readyChanged();
  /// Emitted when no case could be opened; the window has already shown the error.
  void caseFailed(const QString& what);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  struct Room {
    QString id, title;
    Workspace* workspace;
  };
  void makeActions();
  void arrange();
  void connectAll();
  void fillRecent();
  void fillView();
  bool passKey(QKeyEvent& event);
  void switchTo(int index);
  void take(const LoadedCase& loaded);
  void takeMade(std::shared_ptr<const PatientCase> patient);
  CaseOrigin origin() const;
  void handOut();
  void showTitle();
  void showOpening();
  void showSaved(const SavedCase& saved);
  std::vector<CaseEdit> unsavedEdits() const;
  std::vector<CaseEdit> quietEdits() const;
  bool isWithoutFolder() const;
  Loss loss() const;
  void confirmDiscard(LostBy by, std::function<void()> go);
  void saveTo(const QString& folder);
  void fail(const QString& what, const QString& advice, const QString& details);
  void updateStatus();
  void chooseCase();
  void chooseImport();
  void chooseAttempt();
  const Room* attemptRoom() const;
  void chooseTarget();
  void showHelp(bool keys);

  std::unique_ptr<Account> account_;
  std::vector<Room> rooms_;
  LoadedCase case_;
  QMenu *menu_, *recent_;
  QAction *open_ = nullptr, *import_ = nullptr, *textbook_ = nullptr, *library_ = nullptr, *reload_ = nullptr,
          *save_ = nullptr, *saveAs_ = nullptr, *attempt_ = nullptr;
  QMenu* view_;
  SiteExchange* site_;
  AccountMenu* accountMenu_;
  bool sure_ = false;     ///< close without asking, even if changes are lost
  bool passing_ = false;  ///< a key event is being passed to the workspace
  HeaderBar* header_;
  TaskBar* tasks_;
  ErrorPanel* errors_;
  QStackedWidget* stack_;
  StatusStrip* status_;
  CaseLoader* loader_;
  CaseExchange* exchange_;
  HelpWindow* help_ = nullptr;
  std::function<void()> afterSaving_;  ///< called when the pending save has succeeded
};

}  // namespace insonate::ui
