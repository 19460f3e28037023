#pragma once

class QHBoxLayout;
class QSplitter;
class QStackedLayout;
class QWidget;

namespace insonate::ui {
class EmptyWorkspace;
class ViewWidget;
class Workspace;
}  // namespace insonate::ui

namespace insonate::prepare {

class CaseViews;
class PathColumn;
struct PrepareModel;
class RightColumn;

/// The workspace's layout: slots that the features fill, and views that the features share.
class PrepareLayout {
 public:
  PrepareLayout(ui::Workspace& workspace, PrepareModel& model);
  /// Deletes the widgets.
  ~PrepareLayout();

  /// The workspace, which owns the commands and emits signals to the window.
  ui::Workspace& workspace() { return workspace_; }
  /// The page that is shown while no case is open.
  ui::EmptyWorkspace& empty() { return *empty_; }
  PathColumn& path() { return *path_; }
  CaseViews& views() { return *views_; }
  RightColumn& right() { return *right_; }
  QSplitter& columns() { return *columns_; }

  /// Puts a bar above the views, to the right of the earlier bars; the first bar gets the free width.
  void addBar(QWidget* bar);
  /// Puts a bar of the full width above the views and the bars above them.
  void addBanner(QWidget* banner);
  /// Lets a view perform the keys of the workspace's commands. These keys take precedence over the view's own keys and
  /// the window's shortcuts.
  void offerKeys(ui::ViewWidget& view);
  /// Adds the columns to the window, after the features have filled them.
  void assemble();

 private:
  ui::Workspace& workspace_;
  PrepareModel& model_;
  QStackedLayout* pages_;
  ui::EmptyWorkspace* empty_;
  QSplitter* columns_;
  PathColumn* path_;
  QWidget* middle_;
  QHBoxLayout* bars_ = nullptr;
  CaseViews* views_;
  RightColumn* right_;
};

}  // namespace insonate::prepare
