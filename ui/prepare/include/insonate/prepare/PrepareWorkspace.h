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
class ToolSession;

/// The workspace in which an author prepares a case. In the middle slices and 3D; on the left the steps from import to
/// check, with the table of structures; on the right facts, findings and the ultrasound image computed from the labels.
/// Colors and the title belong to the case and are saved with it; visibility and opacity are also stored as the user's
/// settings. Results are computed on background threads, and only while the workspace is shown.
class PrepareWorkspace : public ui::Workspace {
  Q_OBJECT

 public:
  /// `tasks` shows long jobs and must outlive the workspace.
  explicit PrepareWorkspace(ui::TaskBar& tasks, QWidget* parent = nullptr);
  ~PrepareWorkspace() override;

  /// Offers actions that open a case, shown while no case is open; the first one is the default. The caller owns the
  /// actions.
  void offer(QAction* action);
  /// Sets the actions that are offered while a case is open.
  void setCaseActions(QAction* open, QAction* import, QAction* reload);

  void setOpening(const QString& what) override;
  void setOrigin(const ui::CaseOrigin& origin) override;
  void setCase(std::shared_ptr<const PatientCase> patient) override;
  ui::CaseEdit unsavedEdit() const override;
  ui::CaseEdit quietEdit() const override;
  void caseSaved(std::shared_ptr<const PatientCase> patient) override;
  QString statusText() const override;
  QString engineText() const override;
  /// Tells whether the case is measured and checked, and surfaces and the ultrasound image are on the screen.
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

  std::unique_ptr<PrepareModel> model_;  ///< its parts are children of this object, deleted after the widgets
  std::unique_ptr<PrepareLayout> layout_;
  std::vector<Feature*> features_;
  CaseFeature* case_ = nullptr;
  ToolSession* tools_ = nullptr;
  std::unique_ptr<PrepareBenchmark> benchmark_;
  bool isReady_ = false;
};

}  // namespace insonate::prepare
