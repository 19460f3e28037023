#pragma once

#include <insonate/cases/CaseView.h>
#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/Tenting.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Mesh of the tissue model, at rest and displaced, in the probe frame of its image.
struct TissueMesh {
  int columns = 0, rows = 0;        ///< number of nodes
  std::vector<MeshNode> nodes;      ///< [row][column]
  std::vector<float> pressure_kPa;  ///< per cell, (columns-1) x (rows-1); above 0 where the tissue is compressed
};

/// Distance between the points of LivePress::middleAtRest_mm.
inline constexpr double kMiddleStep_mm = 0.5;

/// State of the tissue under the probe. The tissue is at rest if the setup's model is kNoDeformation.
struct LivePress {
  double force_N = 0;  ///< force of the tissue on the probe
  /// Indentation of the face from first contact with the skin; below 0: distance from the skin. NaN: no skin near.
  double indentation_mm = 0;
  std::vector<LumenArea> lumens;  ///< vessel sections in the plane; empty if nothing compresses the tissue and blood is
                                  ///< at its pressure in the CT
  BloodPressure pressure;
  /// Affine map from patient space to the place of the tissue at rest, valid near the needle's tip, before the tip
  /// dents the tissue. The identity without a needle.
  Transform restFromPatient;
  /// Rest positions (patient space) of the tissue along the middle line of the image, from the face to the image's
  /// depth. On the image, the points are kMiddleStep_mm apart.
  std::vector<Vec3> middleAtRest_mm;
  bool settled = true;  ///< false: the model has not converged, and the next image continues the solution
  double solve_ms = 0;  ///< part of frame_ms
  TissueMesh mesh;      ///< empty unless setKeepMesh()
};

/// One frame of a live probe. Constant. A holder may keep it, even after the end of LiveImaging: its memory is reused
/// when the last holder releases it.
struct LiveFrame {
  BModeImage image;
  EnvelopeFrame envelope;        ///< empty unless LiveOptions::keepEnvelopes
  Transform patientFromProbe;    ///< pose of the probe
  std::optional<Needle> needle;  ///< pose of the needle; empty: no needle
  LivePress press;
  std::shared_ptr<const ImagingSetup> setup;                 ///< probe, settings, tissues, engine; never null
  std::shared_ptr<const std::vector<std::string>> warnings;  ///< about the case, e.g. unknown labels; never null
  std::vector<ImagingFrame::Stage> stages;                   ///< empty if the probe is outside the patient
  double frame_ms = 0;                                       ///< wall-clock time from pose to image
  std::string engine, engineNote;  ///< see ImagingFrame; of the last image that an engine computed
  std::uint64_t number = 0;        ///< 1 for the first frame; numbers have no gaps
  double time_s = 0;               ///< since LiveImaging was made
};

enum class LiveState {
  Starting,  ///< the first scene is being built; there is no image yet
  Imaging,
  WaitingForScene,  ///< the probe left the scene; the last image stays until the next scene is built
  Frozen,
  Outside,  ///< the probe's image lies outside the patient's volume: images are black
  Failed,   ///< see message; the last image stays, and the next setup or pose is tried
};

struct LiveStatus {
  LiveState state = LiveState::Starting;
  bool buildingScene = false;
  int scenesBuilt = 0;
  double sceneBuild_ms = 0;  ///< build time of the last scene, wall clock; 0 before the first
  std::string message;       ///< a sentence if something failed; else empty
};

struct LiveOptions {
  int threads = 0;             ///< threads that compute images; 0: every core except one, which is left to the window
  double sceneMargin_mm = 15;  ///< room around the probe within a scene, on each side; 2..100
  double sceneReserve_mm = 9;  ///< the next scene is begun if less room than this is left
  std::size_t cineBytes = 256 << 20;  ///< memory for past frames; the latest frame is always kept
  /// Compute images at lower priority than the rest of the program: see lowerThreadPriority().
  bool background = false;
  bool workAhead = true;       ///< compute the parts of future scenes while processors are idle
  bool keepEnvelopes = false;  ///< also fill LiveFrame::envelope, which takes about six times the memory
  Physiology physiology = {};  ///< see setPhysiology()
  bool pulsating = false;      ///< see setPulsating()
  bool resting = false;        ///< see setResting()
};

/// A probe over a patient, imaged as it moves. If the pose puts the face inside the skin, the tissue is compressed as
/// the setup's mechanics say; this is computed before each image. One thread makes an image whenever pose or setup have
/// changed, or persistence or tissue have not settled. A second thread builds the next scene before the probe leaves
/// the present scene. While the probe is held still, no work is done. A frame allocates nothing once the cine memory is
/// full.
///
/// Every member may be called from any thread. The destructor waits for the frame in progress; a scene that is being
/// built is cancelled.
class LiveImaging {
 public:
  /// Fails on a case without volumes or with differing grids, on a setup that is out of range, and on a pose that is
  /// not rigid.
  static Result<std::unique_ptr<LiveImaging>> make(CaseVolumes patient, const ImagingSetup& setup,
                                                   const Transform& patientFromProbe, const LiveOptions& options = {});
  ~LiveImaging();
  LiveImaging(const LiveImaging&) = delete;
  LiveImaging& operator=(const LiveImaging&) = delete;

  /// Sets the pose. Only the latest pose is imaged; poses set in between are skipped. Never blocks. A pose that is not
  /// finite and rigid is ignored.
  void setPose(const Transform& patientFromProbe);

  /// Sets the needle, and the tissue that its tip pushes ahead, from the next frame on. No needle: no tenting. Only the
  /// latest call counts; it triggers a frame if needle or tenting differ from the call before. Never blocks. A needle
  /// that validate() refuses, or a tenting that is not finite, is ignored.
  void setNeedle(const std::optional<Needle>& needle, const std::optional<Tenting>& tenting = {});

  /// Sets probe, settings, tissues and engine together. The old setup stays in use until a scene for the new setup is
  /// ready. If values are out of range, this fails and the old setup stays. Of several setups set in quick succession,
  /// possibly only the last takes effect.
  Result<void> setSetup(const ImagingSetup& setup);

  /// Sets the pressures that act on the patient's blood, from the next frame on. Fails with a sentence if they are out
  /// of range.
  Result<void> setPhysiology(const Physiology& physiology);

  /// Switches pulsation by heartbeat and breathing. With pulsation, frames are made 30 times a second if a vessel is in
  /// the plane. Without pulsation, blood is at its mean pressure.
  void setPulsating(bool pulsating);

  /// Sets whether the following frames carry the model's mesh (LivePress::mesh), some hundred kilobytes each.
  void setKeepMesh(bool keep);

  /// Freezes the image: once this returns, latest() and cine() are constant. Poses and setups that are set meanwhile
  /// take effect after the freeze.
  void setFrozen(bool frozen);

  /// Pauses imaging. While it is paused, no frames are made, and scenes and their sources (some hundred megabytes) are
  /// released. Frames, pose and setups are kept. After the pause, the next frame comes as soon as a scene is built
  /// again.
  void setResting(bool resting);

  /// The latest frame; null before the first.
  std::shared_ptr<const LiveFrame> latest() const;

  /// The frames of the last `seconds` before the latest frame, oldest first; fewer if cineBytes is full. Empty before
  /// the first frame.
  std::vector<std::shared_ptr<const LiveFrame>> cine(double seconds) const;

  /// Sets a function that is called on the simulation thread after every new frame and every change of state; it must
  /// return quickly. When onFrame returns, the previous function is no longer called. The function must not call
  /// onFrame, and must not destroy this object.
  void onFrame(std::function<void()> listener);

  /// Number of images made in the last second; 0 while the probe is held still.
  double imagesPerSecond() const;
  LiveStatus status() const;

 private:
  class Impl;
  explicit LiveImaging(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
