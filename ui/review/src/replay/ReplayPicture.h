#pragma once

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/ui/LiveFeed.h>

#include <QObject>
#include <memory>
#include <optional>

namespace insonate::review {

/// The ultrasound picture of a time of an attempt, made off the window's thread; of many times in a row, the latest is
/// what counts. For the window's thread.
class ReplayPicture : public QObject {
  Q_OBJECT

 public:
  explicit ReplayPicture(QObject* parent = nullptr);
  ~ReplayPicture() override;

  /// What pictures are made of; null for none.
  void set(std::shared_ptr<const PatientCase> patient, const AttemptHeader& header);
  /// What the hands do now, and how the patient lies; none without a probe.
  void show(const std::optional<AttemptSample>& sample, double tilt_deg);

  /// Null until there is one, and while there is no probe.
  const std::shared_ptr<const LiveFrame>& shown() const { return shown_; }
  /// There is a probe, and so a picture to wait for.
  bool isWanted() const { return wanted_; }
  /// shown() is of the pose that was asked for last, and nothing more comes.
  bool isSettled() const;
  QString trouble() const { return trouble_; }

 Q_SIGNALS:
  void changed();

 private:
  void news();
  void start(const AttemptSample& sample);

  std::shared_ptr<const PatientCase> patient_;
  std::optional<ImagingSetup> setup_;
  Transform pose_;
  double tilt_deg_ = 0;
  bool wanted_ = false;
  QString trouble_;
  std::shared_ptr<const LiveFrame> shown_;
  ui::LiveFeed feed_;
};

}  // namespace insonate::review
