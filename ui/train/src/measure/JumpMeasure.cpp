#include "JumpMeasure.h"

#include "../model/CaseModel.h"
#include "../model/LiveModel.h"
#include "../model/ProbeMotion.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/simulator/ProbePlacement.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/ui/ViewWidget.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace insonate::train {
namespace {

constexpr int kPause_ms = 300;           // a user looks at the image before the next jump
constexpr int kLongestJump_ms = 60'000;  // a jump without an image counts with this time

JumpRates::Times timesOf(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const auto at = [&](double share) {
    return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
  };
  return {at(0.5), at(0.95), values.back()};
}

/// Over the pixels of the field of view that show an echo in either image.
double meanDifference(const BModeImage& a, const BModeImage& b) {
  if (a.gray.size() != b.gray.size()) return 0;
  double sum = 0;
  int count = 0;
  for (std::size_t n = 0; n < a.gray.size(); ++n) {
    if (a.gray[n] == 0 && b.gray[n] == 0) continue;
    sum += std::abs(int(a.gray[n]) - int(b.gray[n]));
    ++count;
  }
  return sum / std::max(count, 1);
}

}  // namespace

JumpMeasure::JumpMeasure(const CaseModel& patientCase, LiveModel& live, ProbeMotion& motion, ui::ViewWidget& image,
                         int jumps, std::function<void(JumpRates)> done)
    : case_(patientCase), live_(live), motion_(motion), jumps_(jumps), done_(std::move(done)) {
  pause_.setSingleShot(true);
  patience_.setSingleShot(true);
  connect(&image, &ui::ViewWidget::rendered, this, [this] { drawn(); });
  connect(&pause_, &QTimer::timeout, this, [this] { jump(); });
  connect(&patience_, &QTimer::timeout, this, [this] { finish(); });
  pause_.start(kPause_ms);
}

/// On the skin nearest to a random point of the volume, with a random rotation.
std::optional<Transform> JumpMeasure::randomPose() {
  auto hand = motion_.handAtStart();
  if (!hand) return std::nullopt;
  const auto share = [this] { return static_cast<double>(random_()) / static_cast<double>(std::mt19937::max()); };
  const VolumeGeometry& grid = case_.patient()->labels.geometry;
  Vec3 index;
  for (int axis = 0; axis < 3; ++axis) index[axis] = (grid.size[axis] - 1) * share();
  hand->placeAt(grid.patientFromIndex() * index, 360 * share() - 180);
  return hand->pose();
}

void JumpMeasure::jump() {
  const auto pose = randomPose();
  if (!pose) return pause_.start(kPause_ms);
  motion_.beginGesture();
  since_.start();
  waiting_ = true;
  first_ms_.reset();
  coarse_ = nullptr;
  motion_.goTo(toStartPose(*pose));
  patience_.start(kLongestJump_ms);
}

void JumpMeasure::drawn() {
  const auto& frame = live_.shown();
  if (!waiting_ || !frame || frame->patientFromProbe != motion_.pose()) return;
  const double now_ms = double(since_.nsecsElapsed()) / 1e6;
  if (!first_ms_) {
    first_ms_ = now_ms;
    coarse_ = frame->isCoarse ? frame : nullptr;
  }
  if (frame->isCoarse) return;
  if (coarse_) differences_.push_back(meanDifference(coarse_->image, frame->image));
  finish();
}

void JumpMeasure::finish() {
  const double now_ms = double(since_.nsecsElapsed()) / 1e6;
  waiting_ = false;
  patience_.stop();
  first_.push_back(first_ms_.value_or(now_ms));
  full_.push_back(now_ms);
  if (int(full_.size()) < jumps_) return pause_.start(kPause_ms);
  disconnect();
  if (const auto done = std::exchange(done_, nullptr)) {
    const JumpRates::Times differences = timesOf(differences_);
    done({jumps_, timesOf(first_), timesOf(full_), differences.median_ms, differences.p95_ms});
  }
}

}  // namespace insonate::train
