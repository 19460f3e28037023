#pragma once

#include <insonate/ui/Workspace.h>

#include <memory>

class QAction;

namespace insonate::ui {
class TaskBar;
}

namespace insonate::review {

/// The workspace that replays attempts: the list of recordings, an attempt's replay beside the ultrasound and in 3D
/// with a timeline, and its result. Asks the window for the case of an attempt (caseWanted()) if another one is open.
/// Computes on other threads, and nothing while it is hidden.
class ReviewWorkspace : public ui::Workspace {
  Q_OBJECT

 public:
  /// Opening shows in `tasks`, which lives longer.
  explicit ReviewWorkspace(ui::TaskBar& tasks, QWidget* parent = nullptr);
  ~ReviewWorkspace() override;

  /// A way to a recording from elsewhere, beside the list. It belongs to the caller.
  void offer(QAction* action);

  /// Saves the open attempt's result as a page: PDF if the name ends in .pdf, else PNG. Emits written() or failed().
  void saveResult(const QString& file);

  bool opensAttempts() const override { return true; }
  void openAttempt(const QString& file) override;
  void setCase(std::shared_ptr<const PatientCase> patient) override;
  void setAccount(ui::Account& account) override;
  QString statusText() const override;
  QString engineText() const override;
  bool isReady() const override;
  QString helpPage() const override { return QStringLiteral("review"); }
  std::vector<ui::Shortcut> shortcuts() const override;
  void saveLayout(QSettings& settings) const override;
  void restoreLayout(QSettings& settings) override;
  void stop() override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  class Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace insonate::review
