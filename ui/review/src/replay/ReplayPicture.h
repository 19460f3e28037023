#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/LiveImaging.h>

#include <QObject>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>

namespace insonate::review {

/// The ultrasound image of a time of an attempt (AttemptPictures), made off the window's thread, one at a time; of
/// many times that are wanted meanwhile, the latest is what counts. For the window's thread.
class ReplayPicture : public QObject {
  Q_OBJECT

 public:
  explicit ReplayPicture(QObject* parent = nullptr);
  ~ReplayPicture() override;

  /// Sets recording and patient; null for none. Work in progress is discarded.
  void set(std::shared_ptr<const AttemptRecording> recording, std::shared_ptr<const PatientCase> patient);
  void want(std::int64_t time_us);

  /// The image on display; null before the first, and while nobody held the probe.
  const std::shared_ptr<const LiveFrame>& shown() const { return shown_; }
  /// shown() is of the time that was wanted last.
  bool isSettled() const { return !maker_ || madeFor_us_ == wanted_us_; }
  /// Why there is no image, a sentence; empty where there is one.
  QString trouble() const { return trouble_; }
  /// Images that were asked of the simulator so far.
  int made() const { return made_; }

 Q_SIGNALS:
  void changed();

 private:
  class Maker;
  void start();
  void take(const std::shared_ptr<Maker>& maker, std::int64_t time_us,
            const Result<std::shared_ptr<const LiveFrame>>& frame);

  std::shared_ptr<Maker> maker_;
  std::optional<std::int64_t> wanted_us_, madeFor_us_;
  std::shared_ptr<const LiveFrame> shown_;
  QString trouble_;
  int made_ = 0;
  bool making_ = false;
};

}  // namespace insonate::review
