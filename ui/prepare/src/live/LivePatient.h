#pragma once

#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/ProbeHand.h>
#include <insonate/ui/CaseWorker.h>
#include <insonate/ui/LiveFeed.h>

#include <QObject>
#include <QString>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::prepare {

/// Results computed for a patient beside the window: surfaces for 3D, and the ultrasound of the labels, seen by a
/// probe on the skin nearest to the crosshair. Images are made only while it is awake, and only when the probe has
/// moved.
class LivePatient : public QObject {
  Q_OBJECT

 public:
  explicit LivePatient(QObject* parent);
  ~LivePatient() override;

  /// Sets the patient; null for none. `wishes` are the first surfaces.
  void setPatient(std::shared_ptr<const PatientCase> patient, std::vector<ui::SurfaceWish> wishes);
  /// Replaces the patient by the same voxels in other memory: only the live probe is made again.
  void replacePatient(std::shared_ptr<const PatientCase> patient);
  void wantSurface(const ui::SurfaceWish& wish);
  /// Sets the tissues of the author's own labels.
  void setOwnLabels(const OwnLabels& own);
  /// Edited labels in place of the patient's: the image is made of them from now on, and these surfaces.
  /// `outsideMoved`: the probe stands on another skin, or on the first that there is.
  void setLabels(std::shared_ptr<const LabelMap> labels, std::vector<ui::SurfaceWish> wishes, bool outsideMoved);
  /// While asleep, there is no probe and no scene; results stay.
  void setAwake(bool awake);
  /// Ends the threads.
  void stop();

  /// The probe goes to the skin nearest to a patient point; images follow when the slices have had time to.
  void follow(Vec3 patient_mm);
  /// The probe is put at a pose.
  void goTo(const StartPose& pose);
  void setStart(std::optional<StartPose> start);
  /// Sets how far the probe is pressed into the skin.
  void setPress(double mm);
  double press_mm() const { return press_mm_; }
  /// The case's first pose, once known.
  const std::optional<StartPose>& start() const { return start_; }
  /// patientFromProbe; none before it is known.
  std::optional<Transform> pose() const;
  /// Pose on the skin, before pressing.
  std::optional<Transform> standing() const;

  const ImagingSetup& setup() const { return setup_; }
  /// The image on display; null before the first.
  const std::shared_ptr<const LiveFrame>& shown() const { return shown_; }
  /// Tells whether all requested surfaces have arrived, and the image shows the probe's present pose, or says why
  /// there is none.
  bool isSettled() const;
  /// Why there is no image, or that one is on its way; empty otherwise.
  QString state() const;

 Q_SIGNALS:
  void started();  ///< start() is known
  void poseChanged();
  void pictureShown();
  void stateChanged();
  void surfaceMade(int label, std::shared_ptr<const insonate::Mesh> mesh);

 private:
  void makeWorker(std::vector<ui::SurfaceWish> wishes, bool withHand);
  void startLive();
  void startLiveOf(std::shared_ptr<const LabelMap> tissues);
  void forgetTissues();
  void findSkin();
  void news();
  void rememberPlace();
  void moved();

  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const LabelMap> labels_;  ///< edited; null for the patient's own
  OwnLabels own_;
  ImagingSetup setup_;
  std::optional<StartPose> start_;
  std::optional<ProbeHand> hand_;
  std::optional<Vec3> wanted_mm_;  ///< where to go when there is a hand
  QTimer showing_;                 ///< until images follow the crosshair
  struct Chosen {
    Transform pose;
    double press_mm;
  };
  std::optional<Chosen> chosen_;  ///< where the author put it, once there is a hand; edits may take the skin from it
  std::shared_ptr<const LiveFrame> shown_;
  LiveStatus status_;
  QString trouble_;
  double press_mm_ = 0;
  bool awake_ = false, surfacesDone_ = true;
  int skin_ = 0;     ///< of several that are looked for, the last counts
  int tissues_ = 0;  ///< of several maps that are made of labels, too
  bool tissuesDue_ = false;
  bool stale_ = false;  ///< a live probe has begun that has not made an image yet
  ui::LiveFeed feed_;
  std::unique_ptr<ui::CaseWorker> worker_;
};

}  // namespace insonate::prepare
