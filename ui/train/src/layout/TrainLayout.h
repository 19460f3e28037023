#pragma once

#include "ImageColumn.h"
#include "SharedViews.h"

class QAction;
class QStackedWidget;

namespace insonate::ui {
class Workspace;
}

namespace insonate::train {

class Columns;
class ControlsColumn;
class LeftColumn;

/// The workspace's layout: slots that the features fill, and the shared views.
class TrainLayout {
 public:
  explicit TrainLayout(ui::Workspace& workspace);
  /// Deletes the widgets.
  ~TrainLayout();

  /// The workspace, which is the parent of dialogs and emits signals to the window.
  ui::Workspace& workspace() { return workspace_; }
  SharedViews& views() { return *views_; }
  Columns& columns() { return *columns_; }
  LeftColumn& left() { return *left_; }
  ControlsColumn& controls() { return *controls_; }
  ImageColumn& image() { return *image_; }

  /// Sets the views of the patient, the content of the third column.
  void setPatient(QWidget* views);
  /// Adds a widget above the views of the patient.
  void addAbovePatient(QWidget* widget);
  /// Adds the columns to the window, after the features have filled them.
  void assemble();

  /// Adds a page that can replace the controls.
  void addControlsPage(QWidget* page);
  /// Shows a page in place of the controls; null restores the controls.
  void showControlsPage(QWidget* page);

  /// Shows a page in place of all columns; null restores the columns.
  void showPage(QWidget* page);
  bool isPageShown() const;

  /// Adds an entry at the top of the View menu.
  void addToViewMenu(QAction& action);

 private:
  ui::Workspace& workspace_;
  SharedViews* views_;
  ControlsColumn* controls_;
  QStackedWidget* leftPages_;
  LeftColumn* left_;
  ImageColumn* image_;
  Columns* columns_;
  QWidget *patient_, *page_ = nullptr;
};

}  // namespace insonate::train
