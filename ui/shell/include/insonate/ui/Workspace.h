#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/ui/Commands.h>

#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <memory>
#include <vector>

class QSettings;

namespace insonate::ui {

class Account;
class Sound;
class TaskBar;

/// Origin of a case.
struct CaseOrigin {
  QString folder;     ///< folder of the case; empty if it is not on disk
  QStringList notes;  ///< sentences about what was missing or changed during loading
  bool builtIn = false;
  /// Folder of the case of which this is an earlier or published version, to which edits must not be written; the
  /// case's own folder if it was downloaded from a server; else empty.
  QString versionOf{};
  QString readFrom{};  ///< folder from which the case was read, also if it is that of a version; else empty
  /// True: labels were imported into the case since it was read, so that its labels differ from those in the folder.
  bool labelsReplaced = false;

  bool isDownloaded() const { return !versionOf.isEmpty() && versionOf == readFrom; }
};

/// Function that changes a copy of a case; called on a background thread.
using CaseEdit = std::function<void(PatientCase&)>;

/// Base class of the workspaces Prepare, Train and Review. They exist as long as the window, which shows one of them at
/// a time. A hidden workspace should use no computing time (showEvent, hideEvent). The window's View menu lists the
/// actions() of the workspace that is shown. May be used only on the window's thread.
class Workspace : public QWidget {
  Q_OBJECT

 public:
  explicit Workspace(QWidget* parent = nullptr);

  /// Returns the registry of the workspace's commands, to which features add their commands.
  Commands& commands() { return *commands_; }

  /// Sets the open case; null: no case is open. The case does not change while it is shared.
  virtual void setCase(std::shared_ptr<const PatientCase> patient) = 0;

  /// Sets the text about a case that is being opened, for example "Opening the built-in neck", while no case is open;
  /// empty: no case is being opened.
  virtual void setOpeningText(const QString& /*what*/) {}

  /// Sets the case's origin. Called before setCase(), and after the case was saved to another folder.
  virtual void setOrigin(const CaseOrigin&) {}

  /// Sets the account of the user; called once, before the workspace is shown.
  virtual void setAccount(Account&) {}

  /// Returns an edit that applies the workspace's unsaved changes to a case; null if there are none. The window asks
  /// before such changes would be lost.
  virtual CaseEdit unsavedEdit() const { return {}; }
  /// Returns an edit that applies those changes, such as visibility, that are saved with the case but may be lost
  /// without asking the user; null if there are none.
  virtual CaseEdit unpromptedEdit() const { return {}; }
  /// Called when the case was saved with the edits of all workspaces. `patient` is the saved case, which replaces the
  /// present one.
  virtual void caseSaved(std::shared_ptr<const PatientCase> patient) { setCase(std::move(patient)); }

  /// Returns a sentence about an activity that ends if another case is opened or the window is closed, for example an
  /// attempt in progress; empty if there is none. The window asks the user first.
  virtual QString interruptionWarning() const { return {}; }
  /// Returns a sentence about an activity that survives the opening of another case, but not the end of the window, for
  /// example writing a file; empty if there is none. The window asks the user before it closes.
  virtual QString windowCloseWarning() const { return {}; }

  /// Returns a sentence that says why the window must not show another workspace, for example because that workspace
  /// would reveal answers during a test; empty if the window may show another one.
  virtual QString workspaceChangeBlocker() const { return {}; }

  /// Tells whether the workspace shows recorded attempts. The window opens an attempt in the first workspace that does.
  virtual bool canOpenAttempts() const { return false; }
  /// Begins to open a recorded attempt and returns at once. Emits failed() after an error.
  virtual void openAttempt(const QString& /*file*/) {}

  /// Returns a sentence for the status bar about the last event or about the next thing to do.
  virtual QString statusText() const { return {}; }
  /// Returns engine and frame rate for the right side of the status bar; empty if no images are computed.
  virtual QString engineText() const { return {}; }
  /// Returns a sentence that says why the program chose the ultrasound engine in engineText(); may be empty.
  virtual QString engineNote() const { return {}; }

  /// Tells whether everything essential is on the screen, for example the first live image.
  virtual bool isReady() const { return true; }
  /// Tells whether all results have arrived, for example surfaces after the first image. readyChanged() is also emitted
  /// when this changes.
  virtual bool isComplete() const { return isReady(); }

  /// Returns the name of the workspace's help page: a file in resources/help, without ".md".
  virtual QString helpPage() const { return {}; }

  /// Saves the layout, such as the positions of splitters. The window opens the settings group before the call and
  /// closes it after the call.
  virtual void saveLayout(QSettings&) const {}
  virtual void restoreLayout(QSettings&) {}

  /// Returns the task bar of the window; if the workspace has no window, a task bar of its own. All workspaces share
  /// the task bar, which runs one job at a time: check isRunning() before starting a job.
  TaskBar& tasks();
  void setTasks(TaskBar& tasks) { tasks_ = &tasks; }

  /// Returns the sound of the window; if the workspace has no window, a sound of its own.
  Sound& sound();
  void setSound(Sound& sound) { sound_ = &sound; }

  /// Called when the window closes. Threads must then end within a second. After this call, only the destructor is
  /// called.
  virtual void stop() {}

 Q_SIGNALS:
  void statusChanged();  ///< emitted when statusText() or engineText() has changed
  void readyChanged();
  void editsChanged();   ///< emitted when unsavedEdit() or unpromptedEdit() becomes null or ceases to be null
  void saveRequested();  ///< emitted when the user wants to save the case in its folder
  /// Emitted after an error. `what` says what happened, `advice` what to do; `details` are collapsed. The window shows
  /// all three.
  void failed(const QString& what, const QString& advice, const QString& details);
  /// Emitted when a file was written, with a sentence and the folder of the file; the status bar offers to open the
  /// folder.
  void written(const QString& sentence, const QString& folder);
  /// Emitted when a new case was made from the open one, for example with edited labels. The window passes the new case
  /// to all workspaces.
  void caseMade(std::shared_ptr<const insonate::PatientCase> patient);
  /// Emitted when a case is needed. The window opens the case at this place (see findCaseLocation()).
  void caseRequested(const QString& place);
  /// Emitted when the user wants to see a recorded attempt. The window opens it in the workspace for which
  /// canOpenAttempts() is true.
  void attemptRequested(const QString& file);

 private:
  Commands* commands_;
  TaskBar* tasks_ = nullptr;
  Sound* sound_ = nullptr;
};

}  // namespace insonate::ui
