#pragma once

#include "model/PrepareModel.h"

#include <insonate/prepare/PrepareWorkspace.h>

class QAction;
class QKeyEvent;
class QSplitter;
class QStackedLayout;

namespace insonate::ui {
class EmptyWorkspace;
}

namespace insonate::prepare {

class CaseViews;
class GuideSession;
class LabellingMeasure;
class PathPanel;
class RightColumn;
class ToolSession;
struct KeyRow;

/// The parts of the workspace, and their connections.
class PrepareWorkspace::Parts : public QObject {
 public:
  Parts(PrepareWorkspace& workspace, ui::TaskBar& tasks);
  ~Parts() override;

  PrepareModel shared;  ///< its parts are children of the workspace, deleted after its widgets
  GuideSession& guide;  ///< child of the workspace, too
  ui::EmptyWorkspace* empty = nullptr;
  QSplitter* columns = nullptr;
  PathPanel* path = nullptr;
  CaseViews* views = nullptr;
  bool ready = false;

  /// Sets whether the workspace works. While it does not, no job begins and no image is computed.
  void setAwake(bool awake);
  void stop();
  bool key(const QKeyEvent& event, bool act);
  /// Handles a key event of a canvas by the key table, before the canvas's view does.
  bool canvasEvent(QEvent* event);
  void saveLayout(QSettings& settings) const;
  void restoreLayout(QSettings& settings);
  QString engineText() const;
  void measureLabelling(int repeats, std::function<void(std::vector<LabellingTime>)> done);

 private:
  void buildEmpty();
  void makeActions();
  void connectParts();
  void act(const KeyRow& row);
  QWidget* buildMiddle();
  void showTool();
  void showMouseOwner();
  void refreshSave();
  void refreshReady();
  void makeStructure(std::uint8_t label);

  PrepareWorkspace& workspace_;
  QStackedLayout* pages_ = nullptr;
  ToolSession* tools_ = nullptr;
  RightColumn* right_ = nullptr;
  QAction* save_ = nullptr;
  std::unique_ptr<LabellingMeasure> measure_;
};

}  // namespace insonate::prepare
