#include "LiveMeasure.h"

#include "../model/ImagingModel.h"
#include "../model/LiveModel.h"
#include "../model/ProbeMotion.h"

#include <insonate/core/ProcessorTime.h>
#include <insonate/ui/ViewWidget.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::train {
namespace {

constexpr int kHand_ms = 8;  // a mouse reports about as often
/// Images that have come before the measurement; without them it begins after this long all the same.
constexpr std::size_t kFirst = 5;
constexpr double kPatience_s = 30;
constexpr double kReach_mm = 20, kTurn_deg = 15, kPeriod_s = 3;

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + std::lround(share * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

LiveMeasure::LiveMeasure(ImagingModel& imaging, LiveModel& live, ProbeMotion& motion, ui::ViewWidget& image,
                         double seconds, std::function<void(LiveRates)> done)
    : imaging_(imaging), live_(live), motion_(motion), seconds_(seconds), done_(std::move(done)) {
  imaging_.setProbe("linear");
  imaging_.setSettings(settingsFor(imaging_.probe()));
  connect(&live_, &LiveModel::pictureShown, this, [this] { arrived(); });
  connect(&image, &ui::ViewWidget::rendered, this, [this] { drawn(); });
  connect(&hand_, &QTimer::timeout, this, [this] { move(); });
  clock_.start();
  hand_.setTimerType(Qt::PreciseTimer);
  hand_.start(kHand_ms);
}

void LiveMeasure::begin() {
  begun_ = true;
  begun_ms_ = double(clock_.nsecsElapsed()) / 1e6;
  latency_ms_.clear();
  cpu_ms_ = processTime_ms();
  window_ms_ = threadTime_ms();
}

/// Back and forth along a sine: 42 mm/s at most.
void LiveMeasure::move() {
  const double now_s = double(clock_.elapsed()) / 1e3;
  const bool ready = latency_ms_.size() >= kFirst && !live_.status().buildingScene;
  if (!begun_ && (ready || now_s >= kPatience_s)) begin();
  if (begun_ && now_s >= begun_ms_ / 1e3 + seconds_) return finish();
  const auto at = [](double t_s) { return std::sin(2 * std::numbers::pi * t_s / kPeriod_s); };
  const double part = at(now_s) - at(moved_s_);
  moved_s_ = now_s;
  motion_.slide(kReach_mm * part, 0);
  motion_.move(HandAxis::Rotation, kTurn_deg * part);
  sent_.emplace_back(motion_.pose(), double(clock_.nsecsElapsed()) / 1e6);
}

void LiveMeasure::arrived() {
  const auto& frame = live_.shown();
  const auto of = std::ranges::find(sent_, frame->patientFromProbe, &std::pair<Transform, double>::first);
  if (of == sent_.end()) return;
  shown_ms_ = of->second;
  sent_.erase(sent_.begin(), of);
}

void LiveMeasure::drawn() {
  if (!shown_ms_) return;
  latency_ms_.push_back(double(clock_.nsecsElapsed()) / 1e6 - *shown_ms_);
  shown_ms_.reset();
}

void LiveMeasure::finish() {
  hand_.stop();
  LiveRates rates;
  rates.seconds = double(clock_.nsecsElapsed()) / 1e9 - begun_ms_ / 1e3;
  rates.images = int(latency_ms_.size());
  rates.imagesPerSecond = rates.images / rates.seconds;
  const int images = std::max(1, rates.images);
  rates.cpu_ms = (processTime_ms() - cpu_ms_) / images;
  rates.window_ms = (threadTime_ms() - window_ms_) / images;
  rates.median_ms = quantile(latency_ms_, 0.5);
  rates.p95_ms = quantile(latency_ms_, 0.95);
  disconnect();
  if (const auto done = std::exchange(done_, nullptr)) done(rates);
}

}  // namespace insonate::train
