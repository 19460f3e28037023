#pragma once

#include "../feature/Feature.h"
#include "TraceModel.h"

#include <insonate/simulator/LiveImaging.h>
#include <insonate/ui/SoundMixer.h>
#include <insonate/ultrasound/SpectralDoppler.h>

#include <QElapsedTimer>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

namespace insonate::train {

class MModeStrip;
class SpectrumStrip;

/// The feature for traces over time: PW Doppler with its sound, and M-mode.
class TraceFeature final : public Feature {
  Q_OBJECT

 public:
  TraceFeature(TrainModel& model, TrainLayout& layout);

  void save(QSettings& settings) const override;
  void restore(QSettings& settings) override;

 private:
  void addCommands();
  void moveGate(double across_mm, double deeper_mm);
  void follow();
  void takeSpectra();
  void playSound();
  void showFrame();
  void showStillness();

  TraceModel trace_;
  SpectrumStrip* spectrum_;
  MModeStrip* mMode_;
  std::vector<LiveSpectrum> spectra_;  ///< spectra since the last call of takeSpectra()
  QTimer due_;                         ///< runs while spectra are shown
  QTimer still_;                       ///< runs while M-mode is shown
  QElapsedTimer sinceImage_;
  std::shared_ptr<ui::SoundStream> stream_;
  std::optional<DopplerSound> sound_;
  double soundPrf_Hz_ = 0;  ///< PRF for which sound_ was made
};

}  // namespace insonate::train
