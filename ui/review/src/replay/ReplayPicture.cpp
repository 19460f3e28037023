#include "ReplayPicture.h"

#include <insonate/tissue/AcousticTable.h>

#include <algorithm>
#include <cmath>

namespace insonate::review {
namespace {

/// The latest picture is enough.
constexpr std::size_t kCineBytes = std::size_t{4} << 20;

/// Of the presets the one whose field of view is nearest to the recorded one.
Probe probeOf(const PictureField& field) {
  Probe nearest = loadProbe("linear").value_or(Probe{});
  if (field.fanAngle_deg <= 0) return nearest;
  double least = HUGE_VAL;
  for (const std::string& name : probePresetNames()) {
    const auto probe = loadProbe(name);
    if (!probe || probe->shape == ProbeShape::Linear) continue;
    const double off =
        std::abs(probe->fovAngle_deg - field.fanAngle_deg) + std::abs(probe->faceRadius_mm - field.faceRadius_mm);
    if (off < least) least = off, nearest = *probe;
  }
  return nearest;
}

Needle needleAt(const Transform& patientFromNeedle) {
  return {.tip_mm = patientFromNeedle.offset,
          .direction = patientFromNeedle.linear.column[2],
          .bevelNormal = -patientFromNeedle.linear.column[1]};
}

}  // namespace

ReplayPicture::ReplayPicture(QObject* parent) : QObject(parent), feed_([this] { news(); }) {}

ReplayPicture::~ReplayPicture() = default;

void ReplayPicture::set(std::shared_ptr<const PatientCase> patient, const AttemptHeader& header) {
  feed_.set(nullptr);
  patient_ = std::move(patient);
  shown_ = nullptr, wanted_ = false, trouble_.clear(), setup_.reset();
  if (!patient_ || header.picture.sliceHalf_mm <= 0) return;
  const Probe probe = probeOf(header.picture);
  setup_ = ImagingSetup{probe, settingsFor(probe),
                        loadAcousticTable(acousticPresetNames().front()).value_or(AcousticTable{}), "cpu"};
}

void ReplayPicture::start(const AttemptSample& sample) {
  LiveOptions options;
  options.cineBytes = kCineBytes;
  auto live = LiveImaging::make(patient_, *setup_, *sample.patientFromProbe, options);
  if (!live) {
    trouble_ = QString::fromStdString(live.error().message);
    setup_.reset();
    return;
  }
  feed_.set(std::move(*live));
}

void ReplayPicture::show(const std::optional<AttemptSample>& sample, double tilt_deg) {
  wanted_ = setup_ && sample && sample->patientFromProbe;
  if (!wanted_) {
    shown_ = nullptr;
    return;
  }
  const bool otherDepth = sample->pictureDepth_mm > 0 && sample->pictureDepth_mm != setup_->settings.depth_mm;
  if (otherDepth) setup_->settings.depth_mm = sample->pictureDepth_mm;
  if (!feed_.live()) start(*sample);
  if (!feed_.live()) return;
  if (otherDepth) (void)feed_.live()->setSetup(*setup_);
  if (tilt_deg != std::exchange(tilt_deg_, tilt_deg)) {
    Physiology lying;
    lying.tilt_deg = tilt_deg;
    (void)feed_.live()->setPhysiology(lying);
  }
  pose_ = *sample->patientFromProbe;
  feed_.live()->setPose(pose_);
  feed_.live()->setNeedle(sample->patientFromNeedle ? std::optional(needleAt(*sample->patientFromNeedle))
                                                    : std::nullopt);
  news();
}

void ReplayPicture::news() {
  if (!wanted_ || !feed_.live()) return;
  const LiveStatus status = feed_.live()->status();
  trouble_ = QString::fromStdString(status.message);
  shown_ = feed_.live()->latest();
  Q_EMIT changed();
}

bool ReplayPicture::isSettled() const {
  return !wanted_ || !trouble_.isEmpty() || (shown_ && shown_->patientFromProbe == pose_ && shown_->press.settled);
}

}  // namespace insonate::review
