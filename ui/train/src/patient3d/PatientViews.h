#pragma once

#include <insonate/simulator/LiveImaging.h>
#include <insonate/surface/Mesh.h>
#include <insonate/views/MprView.h>
#include <insonate/views/SceneView.h>

#include <QByteArray>
#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QButtonGroup;
class QScrollArea;
class QSplitter;
class QStackedWidget;
class QToolButton;

namespace insonate::ui {
class Commands;
class ScenePanel;
class ViewWidget;
}  // namespace insonate::ui

namespace insonate::train {

class FourSlices;
class SceneInput;
class SceneNeedle;
class SliceMenu;
struct TrainModel;

/// The patient in 3D, with probe and image plane, and as CT slices. Both follow the probe at a rate that does not slow
/// the ultrasound image.
class PatientViews : public QWidget {
 public:
  /// `commands`: commands of this column, which appear in tooltips and menus.
  PatientViews(TrainModel& model, const ui::Commands& commands, QWidget* parent = nullptr);
  ~PatientViews() override;

  views::SceneView& scene() { return *scene_; }
  views::MprView& mpr() { return *mpr_; }
  ui::ViewWidget& sceneWidget() { return *sceneWidget_; }
  ui::ViewWidget& mprWidget() { return *mprWidget_; }
  QSplitter& splitter() { return *splitter_; }
  ui::ScenePanel& scenePanel() { return *scenePanel_; }

  void setSliceKind(views::SliceKind kind);
  /// Shows the probe's plane, axial, coronal and sagittal slices at once, with one crosshair.
  void setAllSlices(bool on);
  /// Uses shorter labels on the tabs.
  void setCompact(bool compact);
  bool showsAllSlices() const;
  /// Sets a listener that is called with true when four slices are shown, which need more space than one slice, and
  /// with false when four slices are no longer shown.
  void setRoomRequested(std::function<void(bool more)> listener) { roomRequested_ = std::move(listener); }
  FourSlices& allSlices() { return *four_; }
  /// Applies a preset of views::windowLevelPresets().
  void setSliceWindow(int preset);
  /// Sets a listener that is called when the user changes window or level of a slice.
  void setWindowChanged(const std::function<void(views::WindowLevel)>& listener);
  /// The needle in 3D.
  SceneNeedle& needle() const { return *needle_; }
  /// Turns the 3D view to the right and up, in degrees.
  void turn(double across_deg, double up_deg);
  /// Shows a tray with a new needle beside the patient's chest.
  void setTrayVisible(bool visible);
  /// Sets a listener that is called when the tray is clicked.
  void setTrayTaken(std::function<void()> listener);
  /// Sets whether the views follow the probe.
  void setFollowing(bool following);

 private:
  QWidget* buildMpr(const ui::Commands& commands);
  QWidget* buildSilence();
  QWidget* buildScenePanel(QWidget* parent);
  /// Shows the single slice, the four slices or the 3D settings below the 3D view.
  void showBelow(QWidget* shown);
  void expandPatientColumn(bool more);
  void showCase();
  void showSurface(int label, const Mesh& mesh);
  void placeCamera();
  void sliceToProbe();
  Transform poseNow() const;
  void want();
  void follow();
  void showInPlane(const std::shared_ptr<const LiveFrame>& frame);
  /// Draws wire, dilator and catheter in 3D and in the CT slices.
  void showRods(const SharedRods& rods);
  void showMoving();
  /// Shows or hides anatomy. While anatomy is hidden, the CT is not shown and the skin is opaque.
  void applyDisclosure();

  TrainModel& model_;
  std::shared_ptr<views::SceneView> scene_;
  std::shared_ptr<views::MprView> mpr_;
  std::shared_ptr<views::VtkCase> case_;
  ui::ViewWidget* sceneWidget_ = nullptr;
  ui::ViewWidget* mprWidget_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QStackedWidget* below_ = nullptr;  ///< the CT, or a text if the CT is not shown
  QButtonGroup* kinds_ = nullptr;
  SliceMenu* sliceMenu_ = nullptr;
  QToolButton* howSliced_ = nullptr;
  FourSlices* four_ = nullptr;
  std::function<void(bool)> roomRequested_;
  QByteArray splitBefore_;  ///< sizes of 3D and slice before four slices were shown
  ui::ScenePanel* scenePanel_ = nullptr;
  QScrollArea* sceneScroll_ = nullptr;
  std::shared_ptr<const LiveFrame> inPlane_;   ///< the image that the 3D view shows in the image plane; null: none
  SharedRods rods_;                            ///< instruments that are drawn; null: none
  std::shared_ptr<const ImagingSetup> shape_;  ///< setup of the probe that is drawn
  bool cameraDue_ = false;                     ///< true: the camera must be placed for a new patient
  bool sliceShown_ = false;                    ///< true: the slice shows the present case
  bool following_ = true;
  Transform pose_;
  SceneInput* input_ = nullptr;
  SceneNeedle* needle_ = nullptr;
  struct Looks {
    double skin = 1;
    bool ct = false;
    std::vector<std::uint8_t> shown;  ///< visible structures under the skin
    views::Clipping clipping;
  };
  std::optional<Looks> looksBefore_;   ///< appearance of the scene before anatomy was hidden
  std::optional<Transform> slicedAt_;  ///< pose of the probe when the slice was last set to its plane
  QTimer timer_, rest_;
  QElapsedTimer sinceFollowed_;
};

}  // namespace insonate::train
