#pragma once

#include "DiscardPrompt.h"

#include <insonate/ui/CaseLoader.h>
#include <insonate/ui/Workspace.h>

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

namespace insonate::ui {

class CaseExchange;
class TaskBar;

/// Manages the open case: opens, replaces and saves the case, passes it to the workspaces, collects their edits, and
/// asks the user before data would be lost. Its only widgets are dialogs.
class CaseController : public QObject {
  Q_OBJECT

 public:
  /// `window` is the parent of dialogs and owns the task bar.
  CaseController(TaskBar& tasks, QWidget* window);

  /// Adds a workspace that receives the case and may edit it.
  void addWorkspace(Workspace& workspace);

  const LoadedCase& current() const { return case_; }
  CaseExchange& exchange() { return *exchange_; }
  /// Tells whether there are unsaved changes about which the user must be asked.
  bool isChanged() const;
  /// Tells whether save() would write something.
  bool isSaveUseful() const;
  /// Tells whether a job is running.
  bool isBusy() const;
  /// Returns the title of the running job, for example "Importing neck-ct".
  QString jobTitle() const;
  /// Tells whether the case has never been on disk.
  bool isWithoutFolder() const;

  /// Opens a case folder, a DICOM folder or a volume file. This function and the following ones ask the user first if
  /// data would be lost.
  void open(const QString& path);
  void openBuiltIn(const QString& variant);
  /// Reads the case from its folder again; no effect for a case that is not on disk.
  void reload();
  /// Replaces the open case by a case that was made from it and is not on disk. Does not ask the user.
  void take(std::shared_ptr<const PatientCase> patient);

  /// Writes the case with all edits to its folder; asks for a folder if it has none.
  void save();
  /// Asks for a new folder and writes the case to it.
  void saveAs();

  /// Returns everything that closing the window or opening another case would lose.
  Loss loss(LostBy by) const;
  /// Calls `go` now if nothing would be lost; else calls it after the user has agreed or the case was saved.
  void confirmDiscard(LostBy by, std::function<void()> go);

 Q_SIGNALS:
  /// Emitted when the case, its edits or the state of jobs have changed.
  void changed();
  /// Emitted when all workspaces have received another case.
  void replaced();
  void statusMessage(const QString& sentence, const QString& folder);
  /// Emitted after an error. `what` says what happened, `advice` what to do.
  void failed(const QString& what, const QString& advice, const QString& details);
  /// Emitted in addition to failed() if the case could not be read or written.
  void loadFailed(const QString& what);

 private:
  void connectLoader();
  void takeLoaded(const LoadedCase& loaded);
  void takeSaved(const SavedCase& saved);
  /// Takes the open case with other labels; it keeps its folder.
  void takeLabeled(std::shared_ptr<const PatientCase> patient);
  void handOut();
  CaseOrigin origin() const;
  std::vector<CaseEdit> unsavedEdits() const;
  std::vector<CaseEdit> quietEdits() const;
  void tellBusy();
  void saveTo(const QString& folder);

  TaskBar& tasks_;
  QWidget* window_;
  std::vector<Workspace*> workspaces_;
  LoadedCase case_;
  bool labelsReplaced_ = false;  ///< true: the labels of the case on disk differ, since labels were imported
  CaseLoader* loader_;
  CaseExchange* exchange_;
  std::function<void()> afterSaving_;  ///< called when the pending save has succeeded
};

}  // namespace insonate::ui
