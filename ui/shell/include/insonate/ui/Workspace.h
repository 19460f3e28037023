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
class TaskBar;

/// Origin of a case.
struct CaseOrigin {
  QString folder;     ///< folder of the case; empty if it is not on disk
  QStringList notes;  ///< sentences about what was missing or changed during loading
  bool builtIn = false;
  /// For an earlier or published version: the folder of its case, to which edits must not be written.
  QString versionOf{};
};

/// Function that changes a copy of a case; called on a background thread.
using CaseEdit = std::function<void(PatientCase&)>;

/// One of the window's workspaces: Prepare, Train or Review. Created once and kept. The window shows one at a time; a
/// hidden workspace should use no computing time (showEvent, hideEvent). The window's View menu lists the actions() of
/// the workspace that is shown. For the window's thread only.
class Workspace : public QWidget {
  Q_OBJECT

 public:
  explicit Workspace(QWidget* parent = nullptr);

  /// Commands of this workspace, with their keys. Features add theirs.
  Commands& commands() { return *commands_; }

  /// Sets the case to work on; null: no case is open. A shared case does not change.
  virtual void setCase(std::shared_ptr<const PatientCase> patient) = 0;

  /// Sets the text about a case that is being opened, for example "Opening the built-in neck", while no case is open;
  /// empty: no case is being opened.
  virtual void setOpening(const QString& /*what*/) {}

  /// Sets the case's origin. Called before setCase(), and when the case was saved elsewhere.
  virtual void setOrigin(const CaseOrigin&) {}

  /// Sets the account of the user; called once, before the workspace is shown.
  virtual void setAccount(Account&) {}

  /// Edit that writes the workspace's unsaved changes into a case; null if there are none. The window asks before they
  /// would be lost.
  virtual CaseEdit unsavedEdit() const { return {}; }
  /// Edit that writes changes which are saved along with the case but need no question, such as visibility; null if
  /// there are none.
  virtual CaseEdit quietEdit() const { return {}; }
  /// Called when the case was saved with every workspace's edits; `patient` is the saved case and replaces the present
  /// one.
  virtual void caseSaved(std::shared_ptr<const PatientCase> patient) { setCase(std::move(patient)); }

  /// Sentence about what ends if another case is opened or the window is closed, for example an attempt in progress;
  /// empty if nothing does. The window asks first.
  virtual QString endsWithTheCase() const { return {}; }

  /// Sentence that says why the window must not change to another workspace, for example during a test whose answers
  /// the others show; empty if it may.
  virtual QString blocksWorkspaceChange() const { return {}; }

  /// Tells whether the workspace shows recorded attempts; the window passes attempts to the first workspace that does.
  virtual bool opensAttempts() const { return false; }
  /// Shows a recorded attempt. Returns at once; reports an error by failed().
  virtual void openAttempt(const QString& /*file*/) {}

  /// Sentence about the last event or the next thing to do, shown in the status bar.
  virtual QString statusText() const { return {}; }
  /// Engine and rate, e.g. "processor   62 images/s", shown at the right of the status bar. Empty if nothing is
  /// computed.
  virtual QString engineText() const { return {}; }
  /// A sentence that says why this engine was chosen; empty if there is nothing to say.
  virtual QString engineNote() const { return {}; }

  /// Tells whether everything essential is on the screen, for example the first live image.
  virtual bool isReady() const { return true; }
  /// Tells whether all further results have arrived, for example surfaces after the first image. Announced by
  /// readyChanged(), too.
  virtual bool isComplete() const { return isReady(); }

  /// Name of the workspace's help page: a file in resources/help without ".md".
  virtual QString helpPage() const { return {}; }

  /// Saves splitters and other layout; the window opens the settings group before the call and closes it after.
  virtual void saveLayout(QSettings&) const {}
  virtual void restoreLayout(QSettings&) {}

  /// The bar of long jobs, with progress and Cancel: the window's, or the workspace's own if it has no window. All
  /// workspaces share it, and it runs one job at a time: check isRunning() before.
  TaskBar& tasks();
  void setTasks(TaskBar& tasks) { tasks_ = &tasks; }

  /// Called when the window closes: threads must end within a second. After this, only the destructor is called.
  virtual void stop() {}

 Q_SIGNALS:
  void statusChanged();  ///< emitted when statusText() or engineText() has changed
  void readyChanged();
  void editsChanged();  ///< emitted when unsavedEdit() or quietEdit() becomes null or ceases to be null
  void saveWanted();    ///< emitted when the user wants to save the case in its folder
  /// Emitted after an error. `what` says what happened, `advice` what to do; `details` are collapsed. The window shows
  /// all three.
  void failed(const QString& what, const QString& advice, const QString& details);
  /// Emitted when a file was written, with a sentence and the folder of the file; the status bar offers to open the
  /// folder.
  void written(const QString& sentence, const QString& folder);
  /// Emitted when a new case was made from this one, for example with edited labels: the window passes it to every
  /// workspace.
  void caseMade(std::shared_ptr<const insonate::PatientCase> patient);
  /// Emitted when a case is needed: the window opens the case at this place (placeOfCase()).
  void caseWanted(const QString& place);
  /// Emitted when the user wants to see a recorded attempt: the window opens it in the workspace that shows attempts.
  void attemptWanted(const QString& file);

 private:
  Commands* commands_;
  TaskBar* tasks_ = nullptr;
};

}  // namespace insonate::ui
