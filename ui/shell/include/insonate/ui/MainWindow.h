#pragma once

#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/HandsChoice.h>
#include <insonate/ui/Workspace.h>

#include <QMainWindow>
#include <memory>
#include <vector>

class QMenu;
class QStackedWidget;

namespace insonate::ui {

class Account;
class AccountMenu;
class CaseController;
class ErrorPanel;
class HeaderBar;
class HelpWindow;
class SiteExchange;
class Sound;
class StatusStrip;
class TaskBar;
class WindowMenu;

/// The main window. It shows one workspace, the open case, running jobs and errors. It stores its position, the
/// workspace and recent cases in the user's settings (QSettings of the application). A case folder, DICOM folder,
/// volume file or recorded attempt that is dropped on the window is opened. CaseController manages the case, WindowMenu
/// the commands.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// Opens the store of people at its default address.
  MainWindow();
  explicit MainWindow(std::unique_ptr<Account> account);
  ~MainWindow() override;

  /// Adds a workspace, which the window then owns. `id` identifies the workspace in settings and on the command line.
  /// Add all workspaces before the window is shown.
  void addWorkspace(const QString& id, const QString& title, const QString& iconName, Workspace* workspace);
  /// Shows the workspace with this id. Returns false if there is none.
  bool showWorkspace(const QString& id);
  Workspace* currentWorkspace() const;
  QString currentId() const;

  /// Asks who trains on this computer, and then with which hands, if the program is started for the first time. Do not
  /// call it when a script controls the program.
  void askAtFirstStart();
  /// Restores the layout of the last session.
  void restoreLayout();

  /// Opens a case folder, a DICOM folder, a volume file or a recorded attempt. If unsaved changes or work in progress
  /// would be lost, open(), openTextbook(), showLibrary(), openBuiltIn(), openAttempt() and reload() first ask the
  /// user.
  void open(const QString& path);
  /// Opens the default built-in neck ("Textbook neck").
  void openTextbook();
  /// Shows the library of all available cases.
  void showLibrary();
  /// Opens a built-in neck by its name.
  void openBuiltIn(const QString& variant);
  /// Opens a recorded attempt in the workspace that shows attempts, and shows that workspace.
  void openAttempt(const QString& file);
  /// Reads the case from its folder again. Has no effect on a case that is not on disk.
  void reload();
  /// Writes the case with all edits to its folder. If the case has no folder, asks the user for a folder.
  void saveCase();
  const LoadedCase& current() const;

  /// Tells whether a case is open, no job is running, and the workspace is ready.
  bool isReady() const;
  /// Tells whether all background work of the window has ended.
  bool isComplete() const;

  /// Returns the commands of the window itself, for example "window.case.open".
  Commands& commands() { return *commands_; }
  /// Returns the list of keys: first the keys of the present workspace, then the keys of the window, then the keys of
  /// the other workspaces.
  std::vector<ShortcutGroup> keyList() const;
  Account& account() { return *account_; }
  TaskBar& tasks() { return *tasks_; }
  ErrorPanel& errors() { return *errors_; }
  QString statusText() const;
  QString caseTitle() const;
  /// Closes the window without asking about unsaved changes.
  void closeAtOnce();

 Q_SIGNALS:
  void readyChanged();
  /// Emitted when the user has chosen the devices for probe and needle at the first start.
  void handsChosen(insonate::ui::HandsChoice choice);
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
  void askHands();
  void connectParts();
  void connectController();
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
  CaseController* controller_;
  Sound* sound_;
  WindowMenu* menu_;
  QMenu* view_;
  HeaderBar* header_;
  ErrorPanel* errors_;
  QStackedWidget* stack_;
  StatusStrip* status_;
  HelpWindow* help_ = nullptr;
  bool sure_ = false;     ///< true: the window closes without asking about unsaved changes
  bool passing_ = false;  ///< true: a key event is being passed to the workspace
};

}  // namespace insonate::ui
