#pragma once

#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/ui/LiveFeed.h>

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate::train {

class CaseModel;
class HapticControl;
class ImagingModel;
class StatusLine;

/// The live images of the open case and, while frozen, the images of the last seconds.
class LiveModel : public QObject {
  Q_OBJECT

 public:
  static constexpr double kCine_s = 12;

  LiveModel(CaseModel& patientCase, ImagingModel& imaging, HapticControl& hands, StatusLine& status,
            QObject* parent = nullptr);
  ~LiveModel() override;

  bool isFrozen() const { return frozen_; }
  void setFrozen(bool frozen);
  /// Tells whether the image is live; if not, shows the user a message.
  bool checkLive();
  /// The image on display, live or from the past; null before the first image.
  const std::shared_ptr<const LiveFrame>& shown() const { return shown_; }
  /// Tells whether the image on display belongs to another position of the probe than the present one.
  bool isStale() const { return stale_; }
  /// The images of the last seconds before the freeze, oldest first.
  const std::vector<std::shared_ptr<const LiveFrame>>& cine() const { return cine_; }
  int cineIndex() const { return cineIndex_; }
  void showCine(int index);

  void setPose(const Transform& patientFromProbe);
  /// Sets whether live images include the mesh of the tissue.
  void setMeshRequested(bool wanted);
  /// Sets the gate of PW Doppler; empty: none.
  void setGate(const std::optional<SpectralSettings>& gate);
  /// Takes the spectra since the last call; see LiveImaging::takeSpectra().
  void takeSpectra(std::vector<LiveSpectrum>& spectra);
  /// Sets whether the image is visible. While the image is not visible, vessels do not pulsate, so that a probe at rest
  /// uses no computing time.
  void setWatched(bool watched);
  /// Stops or resumes imaging. While stopped, the last image stays and the memory of the scenes is released.
  void setAwake(bool awake);

  LiveStatus status() const;
  double imagesPerSecond() const;
  /// Sentence that says why there are no images; empty if there are images.
  const std::string& failure() const { return failure_; }
  /// Returns all settings that determine the images now, for the recording of an attempt. Call it only if there is an
  /// image.
  AttemptSettings attemptSettings() const;

 Q_SIGNALS:
  void pictureShown();
  void firstShown();  ///< emitted after all receivers have handled pictureShown() of a case's first image
  void frozenChanged();
  void staleChanged();  ///< emitted when isStale() has changed

 private:
  void start();
  void stop();
  void empty();
  void news();
  void show(std::shared_ptr<const LiveFrame> frame);
  void checkStale();
  void sendSetup();
  bool pulsates() const;
  Physiology physiology() const;
  LiveOptions liveOptions() const;
  void updateTissueRequest();

  CaseModel& case_;
  ImagingModel& imaging_;
  HapticControl& hands_;
  StatusLine& status_;
  bool meshRequested_ = false, watched_ = true, awake_ = true;
  bool frozen_ = false, wasFrozen_ = false;  ///< wasFrozen_: frozen_ for the former case
  bool stale_ = false;
  Transform pose_;  ///< pose that mouse and keys gave the probe
  std::optional<SpectralSettings> gate_;
  std::shared_ptr<const LiveFrame> shown_;
  std::vector<std::shared_ptr<const LiveFrame>> cine_;
  int cineIndex_ = 0;
  std::string failure_;  ///< last reported failure of live imaging
  ui::LiveFeed feed_;
};

}  // namespace insonate::train
