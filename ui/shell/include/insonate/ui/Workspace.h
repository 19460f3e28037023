#pragma once

#include <insonate/cases/PatientCase.h>

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

/// A keyboard shortcut, as the list of keys shows it (`?`).
struct Shortcut {
  QString keys;  ///< as printed on the keyboard, e.g. "Shift + arrows"
  QString does;  ///< e.g. "tilt and rock the probe"
};

/// Origin of a case.
struct CaseOrigin {
  QString folder;     ///< where it is kept; empty for one that is not on disk
  QStringList notes;  ///< what was missing or changed on the way, one sentence each
  bool builtIn = false;
  QString versionOf{};  ///< of an earlier or published version: the folder of its case, where edits do not go
};

/// Changes a copy of a case, on another thread.
using CaseEdit = std::function<void(PatientCase&)>;

/// One of the window's workspaces: Prepare, Train or Review. Made once and kept; the window shows one at a time, and a
/// hidden one should cost no time (showEvent, hideEvent). The window's View menu lists its actions() while it is
/// shown. For the window's thread only.
class Workspace : public QWidget {
  Q_OBJECT

 public:
  using QWidget::QWidget;

  /// Sets the case to work on; null when none is open. The case is constant while it is shared.
  virtual void setCase(std::shared_ptr<const PatientCase> patient) = 0;

  /// While no case is open: text about a case that is being opened, for example "Opening the built-in neck"; empty for
  /// none.
  virtual void setOpening(const QString& /*what*/) {}

  /// Called before setCase(), and when the case was saved elsewhere.
  virtual void setOrigin(const CaseOrigin&) {}

  /// Sets the account of the user; called once, before the workspace is shown.
  virtual void setAccount(Account&) {}

  /// Changes that are not on disk yet; null without changes. The window asks before they would be lost.
  virtual CaseEdit unsavedEdit() const { return {}; }
  /// Changes that are written along with the case but need no question, such as visibility; null without any.
  virtual CaseEdit quietEdit() const { return {}; }
  /// The case was written, with every workspace's edit: it is `patient` from now on.
  virtual void caseSaved(std::shared_ptr<const PatientCase> patient) { setCase(std::move(patient)); }

  /// Sentence about what another case or closing the window would end, for example an attempt in progress; empty for
  /// nothing. The window asks before.
  virtual QString endsWithTheCase() const { return {}; }

  /// Why the window must not change to another workspace, a sentence, e.g. during a test, whose answers the others
  /// show; empty for nothing.
  virtual QString blocksWorkspaceChange() const { return {}; }

  /// Tells whether the workspace shows recorded attempts; the window hands them to the first workspace that does.
  virtual bool opensAttempts() const { return false; }
  /// Shows a recorded attempt. Returns at once; failures are reported by failed().
  virtual void openAttempt(const QString& /*file*/) {}

  /// Sentence about the last event, or the next thing to do: shown in the status bar.
  virtual QString statusText() const { return {}; }
  /// Engine and rate, e.g. "processor   62 images/s": right in the status bar. Empty where nothing is computed.
  virtual QString engineText() const { return {}; }
  /// A sentence that says why this engine was chosen; empty if there is nothing to say.
  virtual QString engineNote() const { return {}; }

  /// Tells whether everything is on screen that belongs there, for example the first live image.
  virtual bool isReady() const { return true; }
  /// Tells whether all further results, for example surfaces after the first image, have arrived. readyChanged()
  /// announces this, too.
  virtual bool isComplete() const { return isReady(); }

  /// The help page about this workspace: a file's name in resources/help without ".md".
  virtual QString helpPage() const { return {}; }
  /// Keys that work here, besides those of the window.
  virtual std::vector<Shortcut> shortcuts() const { return {}; }

  /// Splitters and the like; the window opens the group before and closes it after.
  virtual void saveLayout(QSettings&) const {}
  virtual void restoreLayout(QSettings&) {}

  /// The bar of long jobs, with progress and Cancel: the window's, or one of its own without a window. One job at a
  /// time, also between workspaces: check isRunning() before.
  TaskBar& tasks();
  void setTasks(TaskBar& tasks) { tasks_ = &tasks; }

  /// The window closes: threads end within a second. Nothing is called afterwards but the destructor.
  virtual void stop() {}

 Q_SIGNALS:
  void statusChanged();  ///< statusText() or engineText() have a new value
  void readyChanged();
  void editsChanged();  ///< unsavedEdit() or quietEdit() began or ceased to be null
  void saveWanted();    ///< the case is to be written where it is kept
  /// A sentence that says what happened, and one that says what to do; details are folded away. Shown in the window.
  void failed(const QString& what, const QString& advice, const QString& details);
  /// Something was written: a sentence, and the folder it lies in, which the status bar offers to open.
  void written(const QString& sentence, const QString& folder);
  /// Another case came of this one, e.g. edited labels: the window gives it to every workspace.
  void caseMade(std::shared_ptr<const insonate::PatientCase> patient);
  /// A case is needed: the window opens the one at this place (placeOfCase()).
  void caseWanted(const QString& place);
  /// A recorded attempt is to be seen: the window opens it in the workspace that shows attempts.
  void attemptWanted(const QString& file);

 private:
  TaskBar* tasks_ = nullptr;
};

}  // namespace insonate::ui
