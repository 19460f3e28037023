#pragma once

#include <deque>
#include <list>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace insonate::ui {

/// Rate of all sounds.
inline constexpr int kSoundRate_Hz = 48000;

/// A continuous sound, for example that of spectral Doppler. Its source appends samples while earlier ones are played.
/// Sound begins once kLead_s of samples are waiting, and again after the source was late. If more than kMost_s are
/// waiting, the oldest are dropped, so that the sound never falls behind the image. May be used on any thread.
class SoundStream {
 public:
  static constexpr double kLead_s = 0.08, kMost_s = 0.3;

  /// Appends mono samples between -1 and 1 at kSoundRate_Hz.
  void append(std::span<const float> samples);
  /// Drops the samples that are waiting.
  void clear();
  /// Adds the next samples to `out`; nothing while too few are waiting.
  void addTo(std::span<float> out);

 private:
  std::mutex mutex_;
  std::deque<float> waiting_;
  bool running_ = false;
};

/// Mixes the sounds of several sources to one mono signal. May be used on any thread; no function waits for the sound
/// device.
class SoundMixer {
 public:
  /// Adds a short sound, for example a beep: mono samples between -1 and 1 at kSoundRate_Hz, which begin with the next
  /// samples that mix() returns.
  void play(std::span<const float> samples);
  /// Adds a continuous sound, which ends when its last owner other than the mixer releases it.
  std::shared_ptr<SoundStream> openStream();
  /// Drops all sounds that are waiting.
  void clear();
  /// Replaces `out` by the next samples of the sum of all sounds, limited to -1 to 1 without clicks.
  void mix(std::span<float> out);

 private:
  struct Beep {
    std::vector<float> samples;
    std::size_t next = 0;
  };
  std::mutex mutex_;
  std::list<Beep> beeps_;
  std::vector<std::shared_ptr<SoundStream>> streams_;
};

}  // namespace insonate::ui
