#pragma once

#include <insonate/procedure/LineState.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// One lead of an ECG: each wave of a beat is a Gaussian curve (McSharry et al., IEEE Trans Biomed Eng 2003, 50:289),
/// without noise. The beats agree with the pulse of a Physiology: the R wave precedes the rise of the arterial pressure
/// in the neck. A wire in the heart causes a premature, wide beat after each normal one (bigeminy) that is followed by
/// a pause, and farther in a tachycardia of wide beats. Extra beats change neither blood pressure nor blood flow: a
/// simplification. Times in seconds as in heartPhaseAt(). Neither waits nor allocates. One object must not be used
/// concurrently.
class Electrocardiogram {
 public:
  struct Beat {
    double time_s = 0;  ///< time of the R wave
    bool isWide = false;
  };
  static constexpr double kTachycardia_perMin = 180;

  /// Adds the beats up to 0.3 s after `time_s`, which must not decrease; a later rhythm does not change them. A jump
  /// ahead by more than 5 s begins a new ECG. `heartRate_perMin`: Physiology::heartRate_perMin; 0: no beats.
  void advance(double time_s, HeartRhythm rhythm, double heartRate_perMin);
  /// Returns the voltage at a time in the last 5 s before that of advance().
  double voltage_mV(double time_s) const;
  /// Returns the beats in the last seconds, oldest first.
  std::span<const Beat> beats() const { return std::span(beats_).first(count_); }
  /// Returns the mean heart rate of the last beats before `time_s`; empty before the third beat.
  std::optional<double> rate_perMin(double time_s) const;

 private:
  void add(const Beat& beat);
  Beat next(HeartRhythm rhythm, double period_s) const;

  std::array<Beat, 32> beats_;
  std::size_t count_ = 0;
  std::optional<double> now_s_;
};

}  // namespace insonate
