#include <insonate/ui/SoundMixer.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace insonate::ui {
namespace {

/// A sound that begins or ends at once would click.
constexpr std::size_t kFade = kSoundRate_Hz / 200;

std::size_t samplesOf(double seconds) {
  return static_cast<std::size_t>(std::lround(seconds * kSoundRate_Hz));
}

/// Passes quiet signals unchanged, and approaches 1 smoothly.
float limited(float sample) {
  constexpr float kKnee = 0.7F;
  const float size = std::abs(sample);
  if (size <= kKnee) return sample;
  return std::copysign(kKnee + (1 - kKnee) * std::tanh((size - kKnee) / (1 - kKnee)), sample);
}

}  // namespace

void SoundStream::append(std::span<const float> samples) {
  const std::lock_guard lock(mutex_);
  waiting_.insert(waiting_.end(), samples.begin(), samples.end());
  const std::size_t most = samplesOf(kMost_s);
  if (waiting_.size() <= most) return;
  // Back to the lead at once, so that one gap replaces many.
  waiting_.erase(waiting_.begin(), waiting_.end() - std::ptrdiff_t(samplesOf(kLead_s)));
}

void SoundStream::clear() {
  const std::lock_guard lock(mutex_);
  waiting_.clear();
  running_ = false;
}

void SoundStream::addTo(std::span<float> out) {
  const std::lock_guard lock(mutex_);
  const bool begins = !running_ && waiting_.size() >= samplesOf(kLead_s);
  running_ = running_ || begins;
  if (!running_) return;
  const std::size_t count = std::min(out.size(), waiting_.size());
  const bool ends = waiting_.size() <= out.size();
  for (std::size_t i = 0; i < count; ++i) {
    float gain = 1;
    if (begins) gain = std::min(gain, float(i) / kFade);
    if (ends) gain = std::min(gain, float(count - 1 - i) / kFade);
    out[i] += gain * waiting_[i];
  }
  waiting_.erase(waiting_.begin(), waiting_.begin() + std::ptrdiff_t(count));
  if (ends) running_ = false;
}

void SoundMixer::play(std::span<const float> samples) {
  // A device that has stopped would let them pile up.
  constexpr std::size_t kMostBeeps = 8;
  const std::lock_guard lock(mutex_);
  if (beeps_.size() == kMostBeeps) beeps_.pop_front();
  beeps_.push_back({{samples.begin(), samples.end()}});
}

std::shared_ptr<SoundStream> SoundMixer::openStream() {
  const std::lock_guard lock(mutex_);
  return streams_.emplace_back(std::make_shared<SoundStream>());
}

void SoundMixer::clear() {
  const std::lock_guard lock(mutex_);
  beeps_.clear();
  for (const auto& stream : streams_) stream->clear();
}

void SoundMixer::mix(std::span<float> out) {
  const std::lock_guard lock(mutex_);
  std::ranges::fill(out, 0.0F);
  for (Beep& beep : beeps_) {
    const std::size_t count = std::min(out.size(), beep.samples.size() - beep.next);
    for (std::size_t i = 0; i < count; ++i) out[i] += beep.samples[beep.next + i];
    beep.next += count;
  }
  beeps_.remove_if([](const Beep& beep) { return beep.next == beep.samples.size(); });
  std::erase_if(streams_, [](const auto& stream) { return stream.use_count() == 1; });
  for (const auto& stream : streams_) stream->addTo(out);
  std::ranges::transform(out, out.begin(), limited);
}

}  // namespace insonate::ui
