#pragma once

#include <insonate/ui/Workspace.h>

#include <memory>

class QAction;

namespace insonate::ui {
class TaskBar;
}

namespace insonate::review {

/// The workspace that replays attempts. It shows the list of recordings, the replay of an attempt as ultrasound image
/// and in 3D with a timeline, and the result of the attempt. If the open case is not the attempt's case, the workspace
/// requests the attempt's case from the window (caseRequested()). Background threads compute the replay, only while the
/// workspace is shown.
class ReviewWorkspace : public ui::Workspace {
  Q_OBJECT

 public:
  /// `tasks` shows the job of opening a recording and must outlive the workspace.
  explicit ReviewWorkspace(ui::TaskBar& tasks, QWidget* parent = nullptr);
  ~ReviewWorkspace() override;

  /// Adds a button beside the list of recordings for an action that opens a recording from another folder. The caller
  /// owns the action.
  void addOpenAction(QAction* action);

  /// Saves the open attempt's result as a page: PDF if the name ends in .pdf, else PNG. Emits written() or failed().
  void saveResult(const QString& file);

  bool canOpenAttempts() const override { return true; }
  void openAttempt(const QString& file) override;
  void setCase(std::shared_ptr<const PatientCase> patient) override;
  void setAccount(ui::Account& account) override;
  QString windowCloseWarning() const override;
  QString statusText() const override;
  QString engineText() const override;
  bool isReady() const override;
  QString helpPage() const override { return QStringLiteral("review"); }
  void saveLayout(QSettings& settings) const override;
  void restoreLayout(QSettings& settings) override;
  void stop() override;

 protected:
  /// Gives keys of this workspace's commands precedence over shortcuts of the window, for example F5 on the page of a
  /// class.
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Parts;
  void connectParts();
  void refreshReady();

  std::unique_ptr<Parts> parts_;
};

}  // namespace insonate::review
