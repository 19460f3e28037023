#pragma once

#include "../ReviewSession.h"

#include <insonate/views/SceneView.h>

#include <QObject>
#include <QTimer>
#include <functional>
#include <memory>
#include <string>
#include <vector>

class QScrollArea;

namespace insonate::ui {
class ScenePanel;
class ViewWidget;
}  // namespace insonate::ui

namespace insonate::review {

/// The patient in 3D, probe and needle as the hands have them, and the path of the needle's tip in the colors of where
/// it was, with signs where that changes. The camera is the user's.
class ReplayScene : public QObject {
 public:
  explicit ReplayScene(ReviewSession& session, QObject* parent = nullptr);

  const std::shared_ptr<views::SceneView>& view() const { return view_; }
  ui::ViewWidget& widget() { return *widget_; }
  /// Structures, CT and clipping plane of the view, and where they scroll.
  ui::ScenePanel& panel() { return *panel_; }
  QScrollArea& panelArea() { return *panelArea_; }
  /// Tells whether no further drawing is due.
  bool isAtRest() const { return !follow_.isActive() && !rest_.isActive(); }
  void setRested(std::function<void()> listener) { rested_ = std::move(listener); }

 private:
  void showCase();
  void showPath();
  void showHands();
  void showProbe(const AttemptSample& sample);
  void placeCamera();

  ReviewSession& session_;
  std::shared_ptr<views::SceneView> view_;
  ui::ViewWidget* widget_;
  ui::ScenePanel* panel_;
  QScrollArea* panelArea_;
  std::shared_ptr<views::VtkCase> case_;
  std::shared_ptr<const PatientCase> shown_;
  std::string settings_;  ///< of the probe as drawn
  std::shared_ptr<const LiveFrame> pictured_;
  bool cameraDue_ = false;
  QTimer follow_, rest_;
  std::function<void()> rested_;
};

/// The tip's path under the skin over a whole attempt: pieces of one color, in patient LPS.
std::vector<views::ScenePath> pathOf(const AttemptDigest& attempt);
/// Outlines of the needle's signs where its place changes: they tell the path's pieces apart without their colors.
std::vector<views::ScenePath> signsOf(const AttemptDigest& attempt);

}  // namespace insonate::review
