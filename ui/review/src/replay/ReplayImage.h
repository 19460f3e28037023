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

/// Computes the ultrasound image at a time of an attempt (AttemptImages) on a background thread, one image at a time.
/// If several times are requested during a computation, only the image of the latest time is computed next. The
/// functions are called on the window's thread.
class ReplayImage : public QObject {
  Q_OBJECT

 public:
  explicit ReplayImage(QObject* parent = nullptr);
  ~ReplayImage() override;

  /// Sets recording and patient; null: none. Drops the computation in progress.
  void set(std::shared_ptr<const AttemptRecording> recording, std::shared_ptr<const PatientCase> patient);
  void want(std::int64_t time_us);

  /// The image on display; null before the first, and at times without a held probe.
  const std::shared_ptr<const LiveFrame>& shown() const { return shown_; }
  /// Tells whether shown() is the image of the time that was requested last.
  bool isSettled() const { return !maker_ || madeFor_us_ == wanted_us_; }
  /// Tells whether shown() is the image of a time that differs from the requested time by more than kSameMoment_us.
  bool isOfAnotherMoment() const;
  static constexpr std::int64_t kSameMoment_us = 500'000;
  /// Sentence that says why there is no image; empty if there is one.
  QString error() const { return error_; }
  /// Number of images that were requested from the simulator so far.
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
  QString error_;
  int made_ = 0;
  bool making_ = false;
};

}  // namespace insonate::review
