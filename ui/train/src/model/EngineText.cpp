#include "EngineText.h"

#include "CaseModel.h"
#include "LiveModel.h"
#include "ProbeMotion.h"

#include <utility>

namespace insonate::train {
namespace {

constexpr double kAtRest = 2;  // images/s
constexpr int kRate_ms = 250;  // often enough to be true, seldom enough to be read

}  // namespace

EngineText::EngineText(CaseModel& patientCase, LiveModel& live, ProbeMotion& motion, QObject* parent)
    : QObject(parent), live_(live), motion_(motion) {
  timer_.setInterval(kRate_ms);
  connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  connect(&patientCase, &CaseModel::caseChanged, this, [this, &patientCase] {
    patientCase.patient() ? timer_.start() : timer_.stop();
    text_.clear();
    Q_EMIT changed();
  });
  connect(&live_, &LiveModel::staleChanged, this, [this] { refresh(); });
}

void EngineText::refresh() {
  const auto& shown = live_.shown();
  QString text = shown && shown->engine == "glsl" ? tr("graphics card") : tr("processor");
  const LiveStatus status = live_.status();
  if (motion_.isUnplaced())
    text.clear();
  else if (live_.isFrozen())
    text += tr("   frozen");
  else if (live_.isStale() || status.state == LiveState::Starting || status.state == LiveState::WaitingForScene)
    text += tr("   preparing the image");
  else if (status.state == LiveState::Outside)
    text += tr("   probe outside the patient");
  else if (shown && shown->isCoarse)
    text += tr("   refining the image");
  else if (shown && live_.imagesPerSecond() < kAtRest)
    // A probe at rest needs no images; that is no slow engine.
    text += tr("   image is up to date   %1 ms").arg(shown->frame_ms, 4, 'f', 1);
  else if (shown)
    text += tr("   %1 fps   %2 ms").arg(live_.imagesPerSecond(), 3, 'f', 0).arg(shown->frame_ms, 4, 'f', 1);
  if (std::exchange(text_, text) != text) Q_EMIT changed();
}

}  // namespace insonate::train
