#pragma once

#include "ImageColumn.h"
#include "SharedViews.h"

#include <QString>

class QAction;
class QStackedWidget;

namespace insonate::ui {
class Workspace;
}

namespace insonate::train {

class Columns;
class ControlsColumn;
class LeftColumn;

/// The layout of the workspace, with slots that the features fill, and the views that they share.
class TrainLayout {
 public:
  explicit TrainLayout(ui::Workspace& workspace);
  /// Deletes the widgets.
  ~TrainLayout();

  /// Parent of dialogs, and emitter of what the window is told.
  ui::Workspace& workspace() { return workspace_; }
  SharedViews& views() { return *views_; }
  Columns& columns() { return *columns_; }
  LeftColumn& left() { return *left_; }
  ControlsColumn& controls() { return *controls_; }
  ImageColumn& image() { return *image_; }

  void setPatient(QWidget* column) { patient_ = column; }
  /// Puts the columns into the window once the features have filled them.
  void assemble();

  /// Adds a page that can take the place of the controls.
  void addControlsPage(QWidget* page);
  /// Shows a page in the place of the controls; null restores them.
  void showControlsPage(QWidget* page);

  /// Shows a page of the workspace in the place of all columns; null restores them.
  void showPage(QWidget* page);
  bool isPageShown() const;

  /// Adds an action in front of the others of the View menu.
  QAction* addAction(const QString& text, const QString& tip, bool isCheckable = true);

 private:
  ui::Workspace& workspace_;
  SharedViews* views_;
  ControlsColumn* controls_;
  QStackedWidget* leftPages_;
  LeftColumn* left_;
  ImageColumn* image_;
  Columns* columns_;
  QWidget *patient_ = nullptr, *page_ = nullptr;
};

}  // namespace insonate::train
