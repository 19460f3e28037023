#pragma once

#include <insonate/cases/CropCase.h>
#include <insonate/ui/Workspace.h>

#include <QObject>
#include <functional>
#include <memory>
#include <vector>

class QAction;
class QMenu;

namespace insonate::ui {

class TaskBar;

/// The open case as it was stored, and the edits since then.
struct OpenCase {
  std::shared_ptr<const PatientCase> patient;
  std::vector<CaseEdit> edits;
};

/// Menu actions that export the open case to other programs, import labels from other programs, and crop the case to
/// make a new case. All actions work on a copy that includes unsaved changes.
class CaseExchange : public QObject {
  Q_OBJECT

 public:
  /// `open` is called when an action is chosen; the task bar belongs to the window.
  CaseExchange(TaskBar& tasks, std::function<OpenCase()> open, QWidget* window);

  void addTo(QMenu& menu);
  /// Disables the actions with a reason, which their tooltips state; enables them without a reason.
  void setObstacle(const QString& reason);

  /// Reads the labels of a file or folder, shows how the program understands them, and replaces the case's labels if
  /// the user agrees. `names`: file that names the numbers of a label map; empty: no such file.
  void importLabels(const QString& file, const QString& names = {});
  void crop(const CropOptions& options);

 Q_SIGNALS:
  /// Emitted when an action has made a new, unsaved case from the open one.
  void made(const std::shared_ptr<const insonate::PatientCase>& patient, const QString& sentence);
  /// Emitted when the labels of the open case were replaced, or replaced again by the former labels. `patient` includes
  /// all unsaved changes of the open case.
  void labelsReplaced(const std::shared_ptr<const insonate::PatientCase>& patient, const QString& sentence);
  void written(const QString& sentence, const QString& folder);
  void failed(const QString& what, const QString& advice, const QString& details);

 private:
  using Write = std::function<Result<void>(const PatientCase&, const std::string&, const Progress&)>;
  QAction* add(const QString& text, const QString& tip, const char* name, std::function<void()> go);
  QAction* addExport(const QString& text, const QString& tip, const char* name, const QString& ending, Write write);
  struct Imported;
  void chooseLabels();
  void showLabels(const QString& file, const std::shared_ptr<Imported>& imported);
  void takeLabels(const std::shared_ptr<Imported>& imported, bool labelsRest);
  void undoImport();
  void chooseCrop();
  void chooseTarget(const QString& title, const QString& ending, const Write& write);
  void write(const QString& target, const Write& write);
  void refuse(const Error& error, const QString& advice);

  TaskBar& tasks_;
  std::function<OpenCase()> open_;
  QWidget* window_;
  std::vector<QAction*> ways_, exports_;
  QAction* undo_;
  std::shared_ptr<const PatientCase> former_;      ///< labels and manifest before the last import, without a CT
  std::weak_ptr<const PatientCase> withImported_;  ///< case with the imported labels
};

}  // namespace insonate::ui
