#pragma once

#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/Workspace.h>

#include <QMainWindow>
#include <memory>
#include <vector>

class QMenu;
class QStackedWidget;

namespace insonate::ui {

class Account;
class AccountMenu;
class CaseDesk;
class ErrorPanel;
class HeaderBar;
class HelpWindow;
class SiteExchange;
class StatusStrip;
class TaskBar;
class WindowMenu;

/// The main window: shows one workspace, the open case, running jobs and errors. Stores its position, the workspace and
/// recent cases in the user's settings (QSettings of the application). Opens a dropped case folder, DICOM folder,
/// volume file or recorded attempt. CaseDesk keeps the case, WindowMenu the commands.
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
  const LoadedCase& current() const;

  /// Tells whether a case is open, no job is running, and the workspace is ready.
  bool isReady() const;
  /// Tells whether all background work of the window has ended.
  bool isComplete() const;

  /// The window's own commands, for example "window.case.open".
  Commands& commands() { return *commands_; }
  /// The list of keys: those of the present workspace first, then the window's, then those of the others.
  std::vector<ShortcutGroup> keyList() const;
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
  void arrange();
  void connectParts();
  void connectDesk();
  void fillView();
  bool passKey(QKeyEvent& event);
  void switchTo(int index);
  void showTitle();
  void showOpening();
  void fail(const QString& what, const QString& advice, const QString& details);
  void updateStatus();
  const Room* attemptRoom() const;
  QString startPage() const;
  HelpWindow& help();

  std::unique_ptr<Account> account_;
  Commands* commands_;
  std::vector<Room> rooms_;
  SiteExchange* site_;
  AccountMenu* accountMenu_;
  TaskBar* tasks_;
  CaseDesk* desk_;
  WindowMenu* menu_;
  QMenu* view_;
  HeaderBar* header_;
  ErrorPanel* errors_;
  QStackedWidget* stack_;
  StatusStrip* status_;
  HelpWindow* help_ = nullptr;
  bool sure_ = false;     ///< close without asking, even if changes are lost
  bool passing_ = false;  ///< a key event is being passed to the workspace
};

}  // namespace insonate::ui
