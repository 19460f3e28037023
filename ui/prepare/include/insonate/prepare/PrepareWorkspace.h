#pragma once

#include <insonate/prepare/LabellingTime.h>
#include <insonate/ui/Workspace.h>

#include <functional>
#include <memory>
#include <vector>

class QAction;

namespace insonate::ui {
class TaskBar;
}

namespace insonate::prepare {

/// The room where a case is made ready: slices and 3D in the middle, the way from import to check with the table of
/// structures on the left, facts, findings and the ultrasound that the labels give on the right. Colors and the title
/// belong to the case and are saved with it; visibility and opacity are the user's own and remembered. Computing
/// happens on other threads; nothing is computed while the room is not shown.
class PrepareWorkspace : public ui::Workspace {
  Q_OBJECT

 public:
  /// Long work shows in `tasks`, which lives longer.
  explicit PrepareWorkspace(ui::TaskBar& tasks, QWidget* parent = nullptr);
  ~PrepareWorkspace() override;

  /// Offers actions that open a case, while none is open; the first one is the default. The caller owns them.
  void offer(QAction* action);
  /// Offered beside an open case.
  void setCaseActions(QAction* open, QAction* import, QAction* reload);

  void setOpening(const QString& what) override;
  void setOrigin(const ui::CaseOrigin& origin) override;
  void setCase(std::shared_ptr<const PatientCase> patient) override;
  ui::CaseEdit unsavedEdit() const override;
  ui::CaseEdit quietEdit() const override;
  void caseSaved(std::shared_ptr<const PatientCase> patient) override;
  QString statusText() const override;
  QString engineText() const override;
  /// Measured and checked, surfaces and the ultrasound image on screen.
  bool isReady() const override;
  QString helpPage() const override { return QStringLiteral("prepare"); }
  std::vector<ui::Shortcut> shortcuts() const override;
  void saveLayout(QSettings& settings) const override;
  void restoreLayout(QSettings& settings) override;
  void stop() override;

  /// Measures looking at the open case and labeling in it, `repeats` times each, while the workspace is shown; results
  /// of tools but the brush are undone. Calls `done` later, unless the workspace is gone by then.
  void measureLabelling(int repeats, std::function<void(std::vector<LabellingTime>)> done);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace insonate::prepare
