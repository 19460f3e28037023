#pragma once

#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/ProbePlacement.h>
#include <insonate/ui/CaseWorker.h>
#include <insonate/ui/LiveFeed.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::prepare {

/// Results that background threads compute for a patient: surfaces for 3D, and the ultrasound image of the labels, as
/// seen by a probe on the skin nearest to the crosshair. Images are computed only after setAwake(true), and only when
/// the probe has moved.
class LivePatient : public QObject {
  Q_OBJECT

 public:
  explicit LivePatient(QObject* parent);
  ~LivePatient() override;

  /// Sets the patient; null: no patient. `wishes` are the first surfaces to compute.
  void setPatient(std::shared_ptr<const PatientCase> patient, std::vector<ui::SurfaceRequest> wishes);
  /// Replaces the patient by one with the same voxels at another address: only live imaging is restarted.
  void replacePatient(std::shared_ptr<const PatientCase> patient);
  void wantSurface(const ui::SurfaceRequest& wish);
  /// Sets the tissues of the author's own labels.
  void setOwnLabels(const OwnLabels& own);
  /// Sets edited labels in place of the patient's. The image and the surfaces in `wishes` are computed from these
  /// labels from now on. `outsideMoved`, true: the skin has changed, so the probe is placed on the skin again.
  void setLabels(std::shared_ptr<const LabelMap> labels, std::vector<ui::SurfaceRequest> wishes, bool outsideMoved);
  /// Starts or stops live imaging. While stopped, there is no live probe and no scene; results stay.
  void setAwake(bool awake);
  /// Ends the background threads.
  void stop();

  /// Moves the probe to the skin nearest to a point of the patient. The probe gets the rotation of the pose that was
  /// chosen last (start(), goTo()) and does not compress the tissue, whatever its rotation and compression were before.
  /// Images follow after a pause, so that the slices are drawn first.
  void follow(Vec3 patient_mm);
  /// Moves the probe to a pose.
  void goTo(const StartPose& pose);
  void setStart(std::optional<StartPose> start);
  /// Sets the depth in mm to which the probe compresses the skin.
  void setPress(double mm);
  double press_mm() const { return press_mm_; }
  /// The case's first start pose; empty until it is known.
  const std::optional<StartPose>& start() const { return start_; }
  /// Present patientFromProbe; empty until it is known.
  std::optional<Transform> pose() const;
  /// Pose of the probe on the skin, without compression.
  std::optional<Transform> standing() const;

  const ImagingSetup& setup() const { return setup_; }
  /// The image on display; null before the first.
  const std::shared_ptr<const LiveFrame>& shown() const { return shown_; }
  /// Tells whether the image on display belongs to another position of the probe than the present one.
  bool isOfFormerPlace() const;
  /// Tells whether the image on display shows the labels or tissues before the last change.
  bool isOfFormerTissue() const { return shown_ && stale_; }
  /// Tells whether all requested surfaces have arrived, and the image shows the probe's present pose or state() says
  /// why there is none.
  bool isSettled() const;
  /// Returns a sentence that says why there is no image, or that an image is being computed; empty otherwise.
  QString state() const;
  /// Tells whether a background thread computes what the next image needs; state() names it.
  bool isBuilding() const;

 Q_SIGNALS:
  void started();  ///< emitted when start() is known
  void poseChanged();
  void pictureShown();
  void stateChanged();
  void surfaceMade(int label, std::shared_ptr<const insonate::Mesh> mesh);

 private:
  void makeWorker(std::vector<ui::SurfaceRequest> wishes, bool withHand);
  void startLive();
  void startLiveOf(std::shared_ptr<const LabelMap> tissues);
  void forgetTissues();
  void findSkin();
  void news();
  void takeHand(ProbePlacement hand);
  void rememberPlace();
  void moved();

  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> labels_;  ///< edited labels; null: the patient's own
  OwnLabels own_;
  ImagingSetup setup_;
  std::optional<StartPose> start_;
  std::optional<ProbePlacement> hand_;
  std::optional<Vec3> wanted_mm_;  ///< point to which the probe is to be moved when there is a ProbePlacement
  QTimer showing_;                 ///< time until images follow the crosshair
  struct Chosen {
    Transform pose;
    double press_mm;
  };
  std::optional<Chosen> chosen_;  ///< pose that the author chose; kept here since edits may remove the skin under it
  std::shared_ptr<const LiveFrame> shown_;
  LiveStatus status_;
  QString error_;
  double press_mm_ = 0;
  double rotation_deg_ = 0;  ///< rotation of the pose that was chosen last
  bool awake_ = false, surfacesDone_ = true;
  int skin_ = 0;     ///< number of the last skin search; earlier results are dropped
  int tissues_ = 0;  ///< number of the last conversion to tissues; earlier results are dropped
  bool tissuesDue_ = false;
  bool stale_ = false;  ///< true: restarted live imaging has not produced an image yet
  ui::LiveFeed feed_;
  std::unique_ptr<ui::CaseWorker> worker_;
};

}  // namespace insonate::prepare
