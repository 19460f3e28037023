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

/// The patient in 3D, with probe and needle in their recorded poses, and the path of the needle's tip. The path's
/// colors show in which tissue or structure the tip was; symbols mark the points where this changes. Only the user
/// moves the camera.
class ReplayScene : public QObject {
 public:
  explicit ReplayScene(ReviewSession& session, QObject* parent = nullptr);

  const std::shared_ptr<views::SceneView>& view() const { return view_; }
  ui::ViewWidget& widget() { return *widget_; }
  /// Controls for structures, CT and clipping plane of the view; panelArea() scrolls them.
  ui::ScenePanel& panel() { return *panel_; }
  QScrollArea& panelArea() { return *panelArea_; }
  /// Tells whether no drawing is pending.
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
  std::string settings_;  ///< attempt settings, as text, of the probe that is drawn
  std::shared_ptr<const LiveFrame> pictured_;
  SharedRods rods_;  ///< instruments of `pictured_`; null: none
  bool cameraDue_ = false;
  QTimer follow_, rest_;
  std::function<void()> rested_;
};

/// Returns the tip's path under the skin over a whole attempt, in pieces of one color; in the patient's frame (LPS).
std::vector<views::ScenePath> pathOf(const AttemptDigest& attempt);
/// Returns outlines of symbols at the points where the needle's place changes. They distinguish the pieces of the path
/// without color.
std::vector<views::ScenePath> signsOf(const AttemptDigest& attempt);

}  // namespace insonate::review
