#include "live/SpectrumThread.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace insonate::live {
namespace {

/// Spectra are computed in groups, so that the thread seldom wakes.
constexpr double kWake_s = 0.015;
/// A computer that is this late leaves spectra out.
constexpr double kLatest_s = 0.25;
/// Maximum number of spectra that wait for take().
constexpr std::size_t kMostWaiting = 400;
/// A probe that has made no image for this long is at rest.
constexpr double kAtRest_s = 0.1;

void recycle(std::vector<LiveSpectrum>& used, std::vector<LiveSpectrum>& unused) {
  for (LiveSpectrum& spectrum : used)
    if (!spectrum.power.empty()) unused.push_back(std::move(spectrum));
  used.clear();
}

}  // namespace

SpectrumThread::SpectrumThread(std::span<const NamedVessel> vessels, std::shared_ptr<const LabelMap> labels,
                               std::function<double()> now_s)
    : vessels_(vessels), labels_(std::move(labels)), now_s_(std::move(now_s)) {}

SpectrumThread::~SpectrumThread() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
  }
  waking_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void SpectrumThread::setGate(const std::optional<SpectralSettings>& gate) {
  {
    const std::lock_guard lock(mutex_);
    const bool began = gate && !on_;
    // A moment from before the gate would state where the vessels were then.
    if (began || !gate) newMoment_.reset();
    if (!gate) recycle(waiting_, unused_);
    began_ = began_ || began;
    newGate_ = gate;
    gateChanged_ = true;
    on_ = gate.has_value();
    if (gate && !thread_.joinable()) thread_ = std::thread([this] { run(); });
  }
  waking_.notify_one();
}

void SpectrumThread::setRunning(bool running) {
  {
    const std::lock_guard lock(mutex_);
    running_ = running;
  }
  waking_.notify_one();
}

void SpectrumThread::show(GateMoment moment) {
  {
    const std::lock_guard lock(mutex_);
    newMoment_ = std::move(moment);
  }
  waking_.notify_one();
}

void SpectrumThread::take(std::vector<LiveSpectrum>& spectra) {
  const std::lock_guard lock(mutex_);
  recycle(spectra, unused_);
  std::ranges::move(waiting_, std::back_inserter(spectra));
  waiting_.clear();
}

LiveSpectrum SpectrumThread::unused() {
  const std::lock_guard lock(mutex_);
  if (unused_.empty()) return {0, std::vector<double>(kSpectrumBins), {}};
  LiveSpectrum spectrum = std::move(unused_.back());
  unused_.pop_back();
  return spectrum;
}

void SpectrumThread::put(LiveSpectrum spectrum) {
  const std::lock_guard lock(mutex_);
  if (!running_ || !on_) return unused_.push_back(std::move(spectrum));
  if (waiting_.size() < kMostWaiting) return waiting_.push_back(std::move(spectrum));
  std::rotate(waiting_.begin(), waiting_.begin() + 1, waiting_.end());
  std::swap(waiting_.back(), spectrum);
  unused_.push_back(std::move(spectrum));
}

void SpectrumThread::run() {
  blood_.emplace(vessels_, labels_.get());
  {
    const std::lock_guard lock(mutex_);
    waiting_.reserve(kMostWaiting), unused_.reserve(2 * kMostWaiting);
    // A busy computer takes spectra late: then more of them are in use than before.
    while (unused_.size() < kMostWaiting) unused_.push_back({0, std::vector<double>(kSpectrumBins), {}});
  }
  double wait_s = HUGE_VAL;
  for (;;) {
    {
      std::unique_lock lock(mutex_);
      const auto due = [this] { return stopping_ || gateChanged_; };
      const auto idle = [this] { return !running_ || !on_; };
      // A new image alone does not wake the thread earlier than its next spectra.
      if (idle() || wait_s == HUGE_VAL)
        waking_.wait(lock, [&] { return due() || (!idle() && (moment_ || newMoment_)); });
      else
        waking_.wait_for(lock, std::chrono::duration<double>(wait_s), due);
      if (stopping_) return;
      if (idle()) next_ = -1;
      takeInputs();
    }
    wait_s = gate_ && moment_ ? compute() : HUGE_VAL;
  }
}

/// The caller holds the mutex.
void SpectrumThread::takeInputs() {
  if (std::exchange(gateChanged_, false)) {
    gate_ = newGate_;
    setup_ = nullptr;
    if (std::exchange(began_, false) || !gate_) {
      moment_.reset();
      isFirst_ = true;
    }
  }
  if (newMoment_) {
    moment_ = std::exchange(newMoment_, std::nullopt);
    held_ = false;
  }
}

double SpectrumThread::compute() {
  const double now = now_s_();
  const auto last = static_cast<long long>(std::floor(now / kSpectrumStep_s));
  if (next_ < 0 || double(last - next_) * kSpectrumStep_s > kLatest_s) next_ = last;
  if (setup_ != moment_->setup) {
    setup_ = moment_->setup;
    doppler_.reset();
    held_ = false;
    if (validate(*gate_, setup_->probe, setup_->settings)) doppler_.emplace(setup_->probe, setup_->settings, *gate_);
  }
  for (; next_ <= last; ++next_) {
    LiveSpectrum spectrum = unused();
    spectrum.time_s = double(next_) * kSpectrumStep_s;
    spectrum.gate = *gate_;
    spectrum.power.assign(kSpectrumBins, 0);
    if (doppler_ && moment_->scene) {
      const auto time_s = moment_->pulsating ? std::optional(spectrum.time_s) : std::nullopt;
      if (!held_) hold();
      const bool moves = spectrum.time_s < moment_->time_s + kAtRest_s;
      doppler_->spectrum(blood_->again(moment_->physiology, time_s), moves ? moment_->tissue_mmps : Vec3{},
                         spectrum.power);
    }
    put(std::move(spectrum));
  }
  return kWake_s;
}

void SpectrumThread::hold() {
  const double interval_s = std::exchange(isFirst_, false) ? 0 : moment_->interval_s;
  const BloodFlow& flow =
      blood_->next(moment_->physiology, std::nullopt, *moment_->displacement, moment_->patientFromProbe, interval_s);
  doppler_->hold(*moment_->scene, moment_->patientFromProbe, *moment_->displacement, flow);
  held_ = true;
}

}  // namespace insonate::live
