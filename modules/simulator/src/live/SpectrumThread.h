#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/MovingBlood.h>
#include <insonate/ultrasound/SpectralDoppler.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

namespace insonate::live {

/// State of the scene for the spectra from one image to the next.
struct GateMoment {
  std::shared_ptr<const AcousticScene> scene;  ///< null: the probe is outside the patient
  std::shared_ptr<const ImagingSetup> setup;
  Transform patientFromProbe;
  std::shared_ptr<const PlaneDisplacement> displacement;
  Physiology physiology;
  bool pulsating = false;
  Vec3 tissue_mmps{};     ///< velocity of the tissue relative to the probe, probe frame
  double time_s = 0;      ///< time of the image
  double interval_s = 0;  ///< time since the image before; 0: there was none
};

/// Computes the spectra of PW Doppler on a thread of its own, one for each kSpectrumStep_s, from the state of the scene
/// at the latest image and the blood flow at the time of the spectrum. Images do not wait for it. The thread begins
/// with the first gate.
class SpectrumThread {
 public:
  /// `now_s` returns the time of live imaging. `vessels` must outlive the object. `labels`: see BloodFlowModel.
  SpectrumThread(std::span<const NamedVessel> vessels, std::shared_ptr<const LabelMap> labels,
                 std::function<double()> now_s);
  ~SpectrumThread();

  /// Sets the gate; empty: no spectra are computed. May be called from any thread, as may take().
  void setGate(const std::optional<SpectralSettings>& gate);
  bool isOn() const { return on_; }
  /// Sets whether time passes; while it does not, no spectra are computed.
  void setRunning(bool running);
  void show(GateMoment moment);
  /// See LiveImaging::takeSpectra().
  void take(std::vector<LiveSpectrum>& spectra);

 private:
  void run();
  void takeInputs();
  /// Computes the spectra that are due. Returns the seconds until the next one.
  double compute();
  void hold();
  /// Returns an entry for a spectrum, with memory that was used before if there is any.
  LiveSpectrum unused();
  void put(LiveSpectrum spectrum);

  const std::span<const NamedVessel> vessels_;
  const std::shared_ptr<const LabelMap> labels_;
  const std::function<double()> now_s_;

  std::mutex mutex_;  ///< guards the following members
  std::condition_variable waking_;
  bool stopping_ = false, running_ = true, gateChanged_ = false;
  bool began_ = false;  ///< true: the present gate follows a time without a gate
  std::optional<SpectralSettings> newGate_;
  std::optional<GateMoment> newMoment_;
  std::vector<LiveSpectrum> waiting_, unused_;  ///< spectra for take(), oldest first; entries that take() got back
  std::atomic<bool> on_{false};

  // Only the thread uses the following members.
  std::optional<SpectralSettings> gate_;
  std::optional<GateMoment> moment_;
  std::shared_ptr<const ImagingSetup> setup_;  ///< setup for which doppler_ was made
  std::optional<SpectralDoppler> doppler_;     ///< empty: the gate does not suit the setup
  bool held_ = false;                          ///< doppler_ holds moment_
  bool isFirst_ = true;                        ///< no moment of this gate has been held
  std::optional<MovingBlood> blood_;
  long long next_ = -1;  ///< number of the next spectrum; its time is next_ * kSpectrumStep_s

  std::thread thread_;  ///< declared last, since the thread uses the other members
};

}  // namespace insonate::live
