#include "ReplayImage.h"

#include <insonate/simulator/AttemptImages.h>

#include <QCoreApplication>
#include <QPointer>
#include <QtConcurrent/QtConcurrent>
#include <cstdlib>
#include <utility>

namespace insonate::review {

/// Renders images, on any thread; created with the first image, since it reads the whole case.
class ReplayImage::Maker {
 public:
  Maker(std::shared_ptr<const AttemptRecording> recording, std::shared_ptr<const PatientCase> patient)
      : recording_(std::move(recording)), patient_(std::move(patient)) {}

  Result<std::shared_ptr<const LiveFrame>> at(std::int64_t time_us) {
    if (!pictures_) pictures_ = AttemptImages::make(recording_, patient_, true);
    if (!*pictures_) return tl::unexpected(pictures_->error());
    return (*pictures_)->at(time_us);
  }

 private:
  std::shared_ptr<const AttemptRecording> recording_;
  std::shared_ptr<const PatientCase> patient_;
  std::optional<Result<AttemptImages>> pictures_;
};

ReplayImage::ReplayImage(QObject* parent) : QObject(parent) {}

ReplayImage::~ReplayImage() {
  set(nullptr, nullptr);
}

void ReplayImage::set(std::shared_ptr<const AttemptRecording> recording, std::shared_ptr<const PatientCase> patient) {
  // Its threads take a fraction of a second to end, too long for the window's thread.
  if (maker_) (void)QtConcurrent::run([old = std::exchange(maker_, nullptr)] {});
  maker_ = recording && patient ? std::make_shared<Maker>(std::move(recording), std::move(patient)) : nullptr;
  wanted_us_.reset(), madeFor_us_.reset();
  shown_ = nullptr;
  error_.clear();
}

void ReplayImage::want(std::int64_t time_us) {
  wanted_us_ = time_us;
  if (maker_ && !making_ && !isSettled()) start();
}

bool ReplayImage::isOfAnotherMoment() const {
  return shown_ && wanted_us_ && madeFor_us_ && std::abs(*wanted_us_ - *madeFor_us_) > kSameMoment_us;
}

void ReplayImage::start() {
  ++made_;
  making_ = true;
  QPointer<ReplayImage> self(this);
  (void)QtConcurrent::run([self, maker = maker_, time_us = *wanted_us_] {
    const auto frame = maker->at(time_us);
    QMetaObject::invokeMethod(qApp, [self, maker, time_us, frame] {
      if (self) self->take(maker, time_us, frame);
    });
  });
}

void ReplayImage::take(const std::shared_ptr<Maker>& maker, std::int64_t time_us,
                       const Result<std::shared_ptr<const LiveFrame>>& frame) {
  making_ = false;
  // Images of another attempt or case are discarded.
  if (maker == maker_) {
    madeFor_us_ = time_us;
    shown_ = frame ? *frame : nullptr;
    error_ = frame ? QString() : QString::fromStdString(frame.error().message);
    Q_EMIT changed();
  }
  if (maker_ && wanted_us_ && !isSettled()) start();
}

}  // namespace insonate::review
