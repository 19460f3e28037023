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
class ScenePanel;
class ViewWidget;
}  // namespace insonate::ui

namespace insonate::train {

class FourSlices;
class SceneInput;
class SceneNeedle;
class SliceMenu;
struct TrainModel;

/// The patient beside the image: in 3D with probe and image plane, and as CT slices. Both follow the probe as often
/// as they can without slowing the ultrasound picture.
class PatientViews : public QWidget {
 public:
  explicit PatientViews(TrainModel& model, QWidget* parent = nullptr);
  ~PatientViews() override;

  views::SceneView& scene() { return *scene_; }
  views::MprView& mpr() { return *mpr_; }
  ui::ViewWidget& sceneWidget() { return *sceneWidget_; }
  ui::ViewWidget& mprWidget() { return *mprWidget_; }
  QSplitter& splitter() { return *splitter_; }
  ui::ScenePanel& scenePanel() { return *scenePanel_; }

  void setSliceKind(views::SliceKind kind);
  /// The probe's plane, axial, coronal and sagittal at once, with one crosshair.
  void setAllSlices(bool on);
  /// Tabs with shorter words.
  void setCompact(bool compact);
  bool showsAllSlices() const;
  /// Sets a listener that is called when four slices begin to need more space than one, and when they cease to.
  void setRoomWanted(std::function<void(bool more)> listener) { roomWanted_ = std::move(listener); }
  FourSlices& allSlices() { return *four_; }
  /// The slice of a canvas; null if the canvas shows none.
  views::MprView* sliceOf(const QObject* canvas);
  /// One of views::windowLevelPresets().
  void setSliceWindow(int preset);
  /// Called when the user changed window or level of the slice.
  void setWindowChanged(const std::function<void(views::WindowLevel)>& listener);
  /// The needle in 3D.
  SceneNeedle& needle() const { return *needle_; }
  /// The view in 3D: to the right and up, in degrees.
  void turn(double across_deg, double up_deg);
  /// Shows a tray with a new needle beside the patient's chest.
  void setTrayVisible(bool visible);
  /// Called when the tray is clicked.
  void setTrayTaken(std::function<void()> listener);
  /// Sets whether the views follow the probe.
  void setFollowing(bool following);

 private:
  QWidget* buildMpr();
  QWidget* buildSilence();
  QWidget* buildScenePanel(QWidget* parent);
  /// Slice, all slices, or what 3D shows.
  void showBelow(QWidget* shown);
  void expandPatientColumn(bool more);
  void showCase();
  void showSurface(int label, const Mesh& mesh);
  void placeCamera();
  void sliceToProbe();
  Transform poseNow() const;
  void want();
  void follow();
  void showMoving();
  /// Shows or hides anatomy: hidden means no CT, and an opaque skin.
  void applyDisclosure();

  TrainModel& model_;
  std::shared_ptr<views::SceneView> scene_;
  std::shared_ptr<views::MprView> mpr_;
  std::shared_ptr<views::VtkCase> case_;
  ui::ViewWidget* sceneWidget_ = nullptr;
  ui::ViewWidget* mprWidget_ = nullptr;
  QSplitter* splitter_ = nullptr;
  QStackedWidget* below_ = nullptr;  ///< the CT, or words where it is not shown
  QButtonGroup* kinds_ = nullptr;
  SliceMenu* sliceMenu_ = nullptr;
  QToolButton* howSliced_ = nullptr;
  FourSlices* four_ = nullptr;
  std::function<void(bool)> roomWanted_;
  QByteArray splitBefore_;  ///< of 3D and the slice, before there were four
  ui::ScenePanel* scenePanel_ = nullptr;
  QScrollArea* sceneScroll_ = nullptr;
  std::shared_ptr<const LiveFrame> followed_;
  std::shared_ptr<const ImagingSetup> shape_;  ///< of the probe as drawn
  bool cameraDue_ = false;                     ///< a new patient is there, and not looked at yet
  bool sliceShown_ = false;                    ///< the slice has the case
  bool following_ = true;
  Transform pose_;
  SceneInput* input_ = nullptr;
  SceneNeedle* needle_ = nullptr;
  struct Looks {
    double skin = 1;
    bool ct = false;
    std::vector<std::uint8_t> shown;  ///< structures under the skin
    views::Clipping clipping;
  };
  std::optional<Looks> looksBefore_;   ///< of the scene, while anatomy is not disclosed
  std::optional<Transform> slicedAt_;  ///< where the probe was when the slice was put there
  QTimer timer_, rest_;
  QElapsedTimer sinceFollowed_;
};

}  // namespace insonate::train
