#pragma once

#include <insonate/ui/Workspace.h>

#include <memory>
#include <vector>

class QAction;

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

class CaseFeature;
class Feature;
class PrepareBenchmark;
class PrepareLayout;
struct PrepareModel;
class RecoveryFeature;
class ToolSession;

/// The workspace in which an author prepares a case. The middle shows slices and 3D. The left side contains the steps
/// from import to check and the table of structures. The right side shows facts, findings and the ultrasound image
/// computed from the labels. Colors and the title are saved with the case; visibility and opacity are saved with the
/// case and as the user's settings. Background threads compute the results, only while the workspace is shown.
class PrepareWorkspace : public ui::Workspace {
  Q_OBJECT

 public:
  /// `tasks` shows long jobs and must outlive the workspace.
  explicit PrepareWorkspace(ui::TaskBar& tasks, QWidget* parent = nullptr);
  ~PrepareWorkspace() override;

  /// Adds an action that opens a case; the workspace offers these actions while no case is open. The first added action
  /// is the default. The caller owns the action.
  void addOpenAction(QAction* action);
  /// Sets the actions that the workspace offers while a case is open. The caller owns the actions.
  void setCaseActions(QAction* open, QAction* import, QAction* reload);

  /// Keeps unsaved work in this folder until it is saved or discarded, and offers work that an earlier program left
  /// there. The folder may contain images of patients and must belong to the user. Without this call, nothing is kept.
  void keepUnsavedWorkIn(const QString& folder);

  void setOpeningText(const QString& what) override;
  void setOrigin(const ui::CaseOrigin& origin) override;
  void setCase(std::shared_ptr<const PatientCase> patient) override;
  ui::CaseEdit unsavedEdit() const override;
  ui::CaseEdit unpromptedEdit() const override;
  void caseSaved(std::shared_ptr<const PatientCase> patient) override;
  QString statusText() const override;
  QString engineText() const override;
  /// Tells whether the case has been measured and checked, and surfaces and the ultrasound image are on the screen.
  bool isReady() const override;
  QString helpPage() const override { return QStringLiteral("prepare"); }
  void saveLayout(QSettings& settings) const override;
  void restoreLayout(QSettings& settings) override;
  void stop() override;

  /// Returns the benchmark of this workspace.
  PrepareBenchmark& benchmark();

 protected:
  bool eventFilter(QObject* canvas, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  void addFeatures();
  template <class T, class... Parts>
  T& add(Parts&... parts);
  void connectModel();
  void checkReady();

  std::unique_ptr<PrepareModel> model_;  ///< parts of the model are children of this object; the model is deleted
                                         ///< after the widgets
  std::unique_ptr<PrepareLayout> layout_;
  std::vector<Feature*> features_;
  CaseFeature* case_ = nullptr;
  RecoveryFeature* recovery_ = nullptr;
  ToolSession* tools_ = nullptr;
  std::unique_ptr<PrepareBenchmark> benchmark_;
  bool isReady_ = false;
};

}  // namespace insonate::prepare
