#include "SceneMeasure.h"

#include "../model/ProbeMotion.h"

#include <insonate/core/ProcessorTime.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/views/SceneView.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kSceneBeat_ms = 4;
/// Longer than this no image of rest is waited for.
constexpr double kRestTimeout_s = 30;
/// A probe counts as moving until now after it came to rest.
constexpr double kMinRest_s = 0.6;
constexpr double kTurn_degps = 60, kWavePeriod_s = 2, kNearer = 0.3, kWaveReach_mm = 10;

double wave(double t_s) {
  return std::sin(2 * std::numbers::pi * t_s / kWavePeriod_s);
}

}  // namespace

SceneMeasure::SceneMeasure(ProbeMotion& motion, ui::ViewWidget& scene, double seconds,
                           std::function<void(VolumeRates)> done)
    : motion_(motion),
      widget_(scene),
      scene_(static_cast<views::SceneView&>(scene.view())),
      seconds_(seconds),
      ctWasVisible_(scene_.isCtVisible()),
      done_(std::move(done)) {
  scene_.setCtVisible(true);
  connect(&beat_, &QTimer::timeout, this, [this] { tick(); });
  beat_.setTimerType(Qt::PreciseTimer);
  beat_.start(kSceneBeat_ms);
  begin(Part::Warm);
}

SceneMeasure::~SceneMeasure() = default;

void SceneMeasure::begin(Part part) {
  part_ = part;
  renderings_ = widget_.renderings();
  moved_s_ = 0;
  sincePart_.start();
  sinceBeat_.start();
  // The probe's own views say when it moves.
  if (part == Part::Orbit || part == Part::Zoom)
    scene_.setMoving(true);
  else if (part != Part::Follow)
    scene_.setMoving(false);
}

void SceneMeasure::move(double part_s) {
  const double before_s = std::exchange(moved_s_, part_s);
  if (part_ == Part::Orbit) scene_.orbit(kTurn_degps * (part_s - before_s), 0);
  if (part_ == Part::Zoom) scene_.zoom(std::exp(kNearer * (wave(part_s) - wave(before_s))));
  if (part_ == Part::Follow) motion_.slide(kWaveReach_mm * (wave(part_s) - wave(before_s)), 0);
}

void SceneMeasure::tick() {
  const double hold_ms = double(sinceBeat_.nsecsElapsed()) / 1e6 - kSceneBeat_ms;
  sinceBeat_.start();
  const double before_ms = std::exchange(beatProcessor_ms_, threadTime_ms());
  if (part_ != Part::Warm) {
    VolumeRates::Holds& holds = rests() ? rates_.rest : rates_.moving;
    holds.longest_ms = std::max(holds.longest_ms, hold_ms);
    holds.processor_ms = std::max(holds.processor_ms, beatProcessor_ms_ - before_ms);
    if (widget_.renderings() != beatRenderings_) (rests() ? restHolds_ms_ : movingHolds_ms_).push_back(hold_ms);
  }
  beatRenderings_ = widget_.renderings();
  const double part_s = double(sincePart_.nsecsElapsed()) / 1e9;
  const bool there = part_s > kMinRest_s && scene_.isExact();
  if (rests() ? there || part_s > kRestTimeout_s : part_s >= seconds_)
    end(part_s);
  else
    move(part_s);
}

void SceneMeasure::end(double part_s) {
  const double perSecond = (widget_.renderings() - renderings_) / part_s;
  switch (part_) {
    case Part::Orbit:
      rates_.orbitPerSecond = perSecond;
      break;
    case Part::Zoom:
      rates_.zoomPerSecond = perSecond;
      break;
    case Part::Follow:
      rates_.followPerSecond = perSecond;
      break;
    case Part::Rest:
      rates_.exact_ms = part_s * 1e3;
      break;
    case Part::LastRest:
      return finish();
    default:
      break;
  }
  begin(Part(int(part_) + 1));
}

void SceneMeasure::finish() {
  part_ = Part::End;
  beat_.stop();
  scene_.setCtVisible(ctWasVisible_);
  for (const auto& [holds, values] : {std::pair{&rates_.moving, &movingHolds_ms_}, {&rates_.rest, &restHolds_ms_}}) {
    if (values->empty()) continue;
    std::ranges::sort(*values);
    holds->min_ms = values->front(), holds->median_ms = (*values)[values->size() / 2];
  }
  if (const auto done = std::exchange(done_, nullptr)) done(rates_);
}

}  // namespace insonate::train
