#pragma once

#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/ui/LiveFeed.h>

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate::train {

class CaseModel;
class HandsControl;
class ImagingModel;
class StatusLine;

/// The live images of the open case, and the last seconds of them while they are frozen.
class LiveModel : public QObject {
  Q_OBJECT

 public:
  static constexpr double kCine_s = 12;

  LiveModel(CaseModel& patientCase, ImagingModel& imaging, HandsControl& hands, StatusLine& status,
            QObject* parent = nullptr);
  ~LiveModel() override;

  bool isFrozen() const { return frozen_; }
  void setFrozen(bool frozen);
  /// Tells whether the image is live; if not, says so to the user.
  bool checkLive();
  /// The image on display: live, or one of the past; null before the first.
  const std::shared_ptr<const LiveFrame>& shown() const { return shown_; }
  /// The last seconds of a frozen image, oldest first.
  const std::vector<std::shared_ptr<const LiveFrame>>& cine() const { return cine_; }
  int cineIndex() const { return cineIndex_; }
  void showCine(int index);

  void setPose(const Transform& patientFromProbe);
  /// Live images come with the mesh of the tissue.
  void setMeshWanted(bool wanted);
  /// While unwatched, the vessels do not move: a probe at rest then costs nothing.
  void setWatched(bool watched);
  /// Asleep, the last image stays, and no others are made; their scenes are given back.
  void setAwake(bool awake);

  LiveStatus status() const;
  double imagesPerSecond() const;
  /// Sentence about why there are no images; empty while there are.
  const std::string& failure() const { return failure_; }
  /// All that decides the images now, for an attempt that is recorded. There must be an image.
  AttemptSettings attemptSettings() const;

 Q_SIGNALS:
  void pictureShown();
  void firstShown();  ///< after all have received pictureShown() of a case's first image
  void frozenChanged();

 private:
  void start();
  void stop();
  void empty();
  void news();
  void show(std::shared_ptr<const LiveFrame> frame);
  void sendSetup();
  bool pulsates() const;
  LiveOptions liveOptions() const;
  void updateTissueRequest();

  CaseModel& case_;
  ImagingModel& imaging_;
  HandsControl& hands_;
  StatusLine& status_;
  bool meshWanted_ = false, watched_ = true, awake_ = true;
  bool frozen_ = false, wasFrozen_ = false;  ///< the latter: of the former case
  std::shared_ptr<const LiveFrame> shown_;
  std::vector<std::shared_ptr<const LiveFrame>> cine_;
  int cineIndex_ = 0;
  std::string failure_;  ///< of the live probe, as last said
  ui::LiveFeed feed_;
};

}  // namespace insonate::train
