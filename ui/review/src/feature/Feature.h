#pragma once

#include <insonate/ui/Commands.h>

#include <QObject>
#include <QString>

class QAction;
class QSettings;
class QWidget;

namespace insonate::ui {
class TaskBar;
class Workspace;
}  // namespace insonate::ui

namespace insonate::review {

class JudgingController;
class ReviewSession;

/// The state that all features share.
struct ReviewModel {
  ui::Workspace& workspace;    ///< the workspace, which emits signals to the window
  ReviewSession& session;      ///< the open attempt
  JudgingController& judging;  ///< trainee and judgements of the open attempt
  ui::TaskBar& tasks;
  QAction& save;  ///< action that saves what is shown
};

/// One feature of the workspace. The constructor makes the feature's widgets, connects them with the model, and adds
/// the feature's commands. ReviewWorkspace.cpp lists the features; they are deleted before the widgets and the model.
class Feature : public QObject {
  Q_OBJECT

 public:
  explicit Feature(const ReviewModel& model);

  /// Tells whether everything that the feature shows is on the screen; readinessChanged() announces changes.
  virtual bool isReady() const { return true; }
  virtual void save(QSettings& /*settings*/) const {}
  virtual void restore(QSettings& /*settings*/) {}

  bool eventFilter(QObject* canvas, QEvent* event) override;

 Q_SIGNALS:
  void readinessChanged();

 protected:
  /// Adds a command that is available while an attempt is open.
  void addForAttempt(ui::Command command);
  /// Passes keys of a widget to the commands, before the window's shortcuts.
  void passKeysOf(QWidget& canvas);

  const ReviewModel model_;
};

}  // namespace insonate::review
