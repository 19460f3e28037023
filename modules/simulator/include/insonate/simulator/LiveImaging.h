#pragma once

#include <insonate/cases/CaseView.h>
#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/Pneumothorax.h>
#include <insonate/simulator/SalineFlush.h>
#include <insonate/simulator/Tenting.h>
#include <insonate/ultrasound/SpectralDoppler.h>

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Mesh of the tissue deformation model with undeformed and present positions, in the probe frame of the image.
struct TissueMesh {
  int columns = 0, rows = 0;        ///< number of nodes in lateral and axial direction
  std::vector<MeshNode> nodes;      ///< nodes in the order [row][column]
  std::vector<float> pressure_kPa;  ///< pressure in each cell, (columns-1) x (rows-1) values; above 0: compression
};

/// Axial distance between the points of LiveDeformation::middleAtRest_mm.
inline constexpr double kMiddleStep_mm = 0.5;

/// Guidewires and catheters that the threads of live imaging share.
using SharedRods = std::shared_ptr<const std::vector<FlexibleRod>>;

/// Deformation of the tissue under the probe for one image. Without a mechanical model (kNoDeformation) the tissue is
/// undeformed.
struct LiveDeformation {
  double force_N = 0;  ///< force of the tissue on the probe
  /// Depth of the probe's face below the position of first contact with the skin. Negative: the face is this far off
  /// the skin. NaN: there is no skin nearby.
  double indentation_mm = 0;
  /// Cross-sectional areas of vessels in the image plane. Empty if the tissue is undeformed, i.e. without contact and
  /// with the blood pressure of the CT.
  std::vector<LumenArea> lumens;
  BloodPressure pressure;
  /// Affine map from the present to the undeformed position of tissue near the needle's tip, patient space. The map
  /// does not include the tenting by the tip. Without a needle the map is the identity.
  Transform restFromPatient;
  /// Displacement of the tissue by the probe, on a lattice of 1 mm or more. The lattice contains no tenting.
  PlaneDisplacement displacement;
  /// Undeformed positions, in patient space, of the tissue on the probe's axis in the image, from the face to the depth
  /// of the image, every kMiddleStep_mm of depth.
  std::vector<Vec3> middleAtRest_mm;
  /// false: the solution for the deformation has not converged yet; it is continued for the next image
  bool settled = true;
  double solve_ms = 0;  ///< time of solving the deformation; part of LiveFrame::frame_ms
  TissueMesh mesh;      ///< deformation mesh; empty unless LiveImaging::setKeepMesh(true)
};

/// One live ultrasound image with the state from which it was computed. A frame does not change. It may be kept even
/// after LiveImaging is destroyed; its memory is reused when the last owner releases it.
struct LiveFrame {
  BModeImage image;
  ColorImage color;  ///< color Doppler over `image`; empty without ImagingSetup::color
  /// echo amplitudes before display processing; empty unless LiveOptions::keepEnvelopes is true
  EnvelopeFrame envelope;
  Transform patientFromProbe;        ///< pose of the probe
  std::optional<Needle> needle;      ///< pose of the needle; empty: no needle
  SharedRods rods;                   ///< guidewires and catheters in the image; null: none
  std::optional<SalineFlush> flush;  ///< flush whose bubbles are in the image; empty: none
  LiveDeformation press;
  std::optional<double> trachea_mm;           ///< AcousticScene::trachea_mm(); empty: the probe is outside the patient
  std::shared_ptr<const ImagingSetup> setup;  ///< probe, settings, tissues, engine; never null
  /// sentences about the case, e.g. unknown labels; never null
  std::shared_ptr<const std::vector<std::string>> warnings;
  /// true: the outlines of structures in the image are coarse, since the probe has just come to this place; images of
  /// full quality follow
  bool isCoarse = false;
  std::vector<ImagingFrame::Stage> stages;  ///< computing times; empty if the probe is outside the patient
  double frame_ms = 0;                      ///< wall-clock time of computing the image, from pose to B-mode
  std::string engine, engineNote;  ///< engine of the last image that was computed, and its note (Engine::note())
  std::uint64_t number = 0;        ///< number of the image, consecutive, from 1
  double time_s = 0;               ///< time since LiveImaging was constructed
};

/// Time between two spectra of PW Doppler.
inline constexpr double kSpectrumStep_s = 0.005;

/// A spectrum of PW Doppler at one moment.
struct LiveSpectrum {
  double time_s = 0;          ///< time since LiveImaging was constructed, a multiple of kSpectrumStep_s
  std::vector<double> power;  ///< see SpectralDoppler::spectrum(); zeros while the probe is outside the patient
  SpectralSettings gate;      ///< gate of the spectrum
};

enum class LiveState {
  /// the first acoustic scene (acoustic properties of the tissue around the probe) is being built; there is no image
  /// yet
  Starting,
  Imaging,
  WaitingForScene,  ///< the probe left the part of the patient that the scene covers; the last image stays until a
                    ///< scene of the new place is built, first a coarse one
  Frozen,
  Outside,  ///< the image region lies outside the patient's volume; images are black
  /// imaging has failed for the reason in LiveStatus::message; the last image stays, and the next setup or pose starts
  /// another try
  Failed,
};

struct LiveStatus {
  LiveState state = LiveState::Starting;
  bool buildingScene = false;
  int scenesBuilt = 0;       ///< number of scenes of full quality that were built
  double sceneBuild_ms = 0;  ///< wall-clock time of building the last of these scenes; 0 before the first
  std::string message;       ///< a sentence if imaging has failed; else empty
};

struct LiveOptions {
  int threads = 0;             ///< threads that compute images; 0: all cores except one, which is left to the GUI
  double sceneMargin_mm = 15;  ///< extent of a scene beyond the image region, on each side; 2 to 100
  /// the next scene is built when the image region is this close to the edge of the present scene
  double sceneReserve_mm = 9;
  std::size_t cineBytes = 256 << 20;  ///< memory for past images; the latest image is always kept
  /// true: images are computed at a lower priority than the rest of the program; see lowerThreadPriority()
  bool background = false;
  bool workAhead = true;  ///< true: parts of scenes that may be needed later are computed while processors are idle
  bool keepEnvelopes = false;  ///< true: LiveFrame::envelope is filled, which takes about six times the memory
  /// heart, breathing and blood pressures at the beginning; see LiveImaging::setPhysiology()
  Physiology physiology = {};
  bool pulsating = false;  ///< true: vessels pulsate from the beginning; see LiveImaging::setPulsating()
  bool paused = false;     ///< true: imaging is paused at the beginning; see LiveImaging::setPaused()
};

/// Live ultrasound imaging of a moving probe over a patient. If the probe's face is below the undeformed skin, the
/// compression of the tissue (ImagingSetup::mechanics) is computed before each image. One thread makes an image
/// whenever pose or setup has changed, and while persistence or deformation still change the image. A second thread
/// builds the next acoustic scene before the probe leaves the present one. After a jump of the probe, the first images
/// are made from a coarse scene (LiveFrame::isCoarse). While nothing changes, no work is done. An image allocates
/// nothing once the cine memory is full, unless its scene is a new one.
///
/// Every member may be called from any thread. The destructor waits for the image in progress; a scene that is being
/// built is cancelled.
class LiveImaging {
 public:
  /// Starts imaging. Fails on a case without volumes or with differing grids, on a setup that is out of range, and on a
  /// pose that is not rigid.
  static Result<std::unique_ptr<LiveImaging>> make(CaseVolumes patient, const ImagingSetup& setup,
                                                   const Transform& patientFromProbe, const LiveOptions& options = {});
  ~LiveImaging();
  LiveImaging(const LiveImaging&) = delete;
  LiveImaging& operator=(const LiveImaging&) = delete;

  /// Sets the probe's pose. The next image uses the latest pose; earlier poses for which no image was made are skipped.
  /// Never blocks. A pose that is not finite and rigid is ignored.
  void setPose(const Transform& patientFromProbe);

  /// Sets the needle and its tenting (tissue that its tip pushes ahead) from the next image on. Without a needle there
  /// is no tenting. The next image uses the latest needle; a call triggers an image if needle or tenting has changed.
  /// Never blocks. A needle that validate() refuses, or a tenting that is not finite, is ignored.
  void setNeedle(const std::optional<Needle>& needle, const std::optional<Tenting>& tenting = {});

  /// Sets the guidewires and catheters that the images show from the next one on; null: none. Only another pointer
  /// triggers an image, so that the rods behind a pointer must not change. Never blocks. Rods of which validate()
  /// refuses one are ignored.
  void setRods(SharedRods rods);

  /// Shows the bubbles of a flush that begins now, whatever SalineFlush::time_s is; empty: no bubbles. They move with
  /// the blood of the case's named vessels for some seconds, in which 30 images per second are made. Never blocks.
  void setFlush(const std::optional<SalineFlush>& flush);

  /// Sets whether the right and the left lung have a pneumothorax, which grows from now on (see Pneumothorax). Never
  /// blocks.
  void setPneumothorax(const std::array<bool, 2>& lungs);

  /// Sets probe, settings, tissues and engine together. The old setup stays in use until a scene for the new setup is
  /// ready. If values are out of range, the function fails and the old setup stays in use. Of several setups that are
  /// set in quick succession, possibly only the last one takes effect.
  Result<void> setSetup(const ImagingSetup& setup);

  /// Sets the patient's blood pressures, heartbeat and breathing from the next image on. Fails with a sentence on
  /// values out of range.
  Result<void> setPhysiology(const Physiology& physiology);

  /// Switches the pulsation of vessels by heartbeat and breathing on or off. With pulsation, 30 images per second are
  /// made while a vessel is in the image plane. Without pulsation, the blood pressure is constant at its mean.
  void setPulsating(bool pulsating);

  /// Sets the gate of PW Doppler; empty: none. While there is a gate, a thread computes a spectrum for each
  /// kSpectrumStep_s, also between two images; images do not wait for it. A gate that validate() refuses for the
  /// present setup has spectra without echoes. Never blocks.
  void setGate(const std::optional<SpectralSettings>& gate);
  /// Replaces the contents of `spectra` with the spectra since the last call, oldest first, at most those of the last
  /// 2 s. Their former memory is used for later spectra, so that no memory is allocated for a spectrum. No spectra are
  /// computed while the image is frozen or paused.
  void takeSpectra(std::vector<LiveSpectrum>& spectra);

  /// Sets whether the following images contain the deformation mesh (LiveDeformation::mesh), some hundred kilobytes
  /// each.
  void setKeepMesh(bool keep);

  /// Freezes the image (true) or unfreezes it (false). When the function has returned, latest() and cine() stay
  /// constant until the image is unfrozen. Poses and setups that are set while the image is frozen take effect when it
  /// is unfrozen.
  void setFrozen(bool frozen);

  /// Pauses (true) or resumes imaging. While paused, no images are made, and the memory of acoustic scenes (some
  /// hundred megabytes) is released; past images, pose and setups are kept. After resuming, the next image comes as
  /// soon as a scene is built again.
  void setPaused(bool paused);

  /// Returns the latest image; null before the first.
  std::shared_ptr<const LiveFrame> latest() const;

  /// Returns the images of the last `seconds` before the latest image, oldest first; fewer if LiveOptions::cineBytes is
  /// full. Empty before the first image.
  std::vector<std::shared_ptr<const LiveFrame>> cine(double seconds) const;

  /// Sets the function that the imaging thread calls after every new image and every change of state. The listener must
  /// return quickly, and must neither call setFrameListener() nor destroy this object. When setFrameListener() has
  /// returned, the previous listener is no longer called.
  void setFrameListener(std::function<void()> listener);

  /// Returns the number of images made in the last second; 0 while nothing changes.
  double imagesPerSecond() const;
  /// Returns the present state of the imaging thread.
  LiveStatus status() const;

 private:
  class Impl;
  explicit LiveImaging(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
