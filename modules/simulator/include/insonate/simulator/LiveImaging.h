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

/// A model's mesh, rest and now, in the probe frame of its picture.
struct TissueMesh {
  int columns = 0, rows = 0;        ///< of nodes
  std::vector<MeshNode> nodes;      ///< [row][column]
  std::vector<float> pressure_kPa;  ///< of its cells, (columns-1) x (rows-1); above 0 where squeezed
};

/// Step of LivePress::middleAtRest_mm.
inline constexpr double kMiddleStep_mm = 0.5;

/// State of the tissue under the probe. All of it is at rest if the setup's model is kNoDeformation.
struct LivePress {
  double force_N = 0;             ///< with which the tissue presses back
  double indentation_mm = 0;      ///< of the face from where it first touches; below 0: off the skin. NaN: no skin near
  std::vector<LumenArea> lumens;  ///< in the plane; empty where nothing presses and blood is as in the CT
  BloodPressure pressure;
  /// Map from patient space to the place of the tissue at rest, near the needle's tip and before the tip dents it:
  /// affine. The identity without a needle.
  Transform restFromPatient;
  /// Rest positions of the tissue along the middle line of the image, from the face to the image's depth; patient
  /// space. The points of the image are kMiddleStep_mm apart.
  std::vector<Vec3> middleAtRest_mm;
  bool settled = true;  ///< false: the model is still on its way, and the next image goes on
  double solve_ms = 0;  ///< part of frame_ms
  TissueMesh mesh;      ///< empty unless setKeepMesh()
};

/// One frame of a live probe. Constant, and may be kept: its memory is reused when the last owner releases it, even
/// after the end of LiveImaging.
struct LiveFrame {
  BModeImage image;
  EnvelopeFrame envelope;        ///< empty unless LiveOptions::keepEnvelopes
  Transform patientFromProbe;    ///< where the probe was
  std::optional<Needle> needle;  ///< where it was
  LivePress press;
  std::shared_ptr<const ImagingSetup> setup;                 ///< probe, settings, tissues, engine; never null
  std::shared_ptr<const std::vector<std::string>> warnings;  ///< about the case, e.g. unknown labels; never null
  std::vector<ImagingFrame::Stage> stages;                   ///< empty where the probe is outside the patient
  double frame_ms = 0;                                       ///< from pose to image, on the clock
  std::string engine, engineNote;                            ///< see ImagingFrame; the last that computed
  std::uint64_t number = 0;                                  ///< 1 for the first; no gaps
  double time_s = 0;                                         ///< since LiveImaging was made
};

enum class LiveState {
  Starting,  ///< the first scene is being built; there is no image yet
  Imaging,
  WaitingForScene,  ///< the probe left the scene; the last image stays until the next scene is built
  Frozen,
  Outside,  ///< the probe looks past the patient's volume: images are black
  Failed,   ///< see message; the last image stays, and another setup or pose is tried
};

struct LiveStatus {
  LiveState state = LiveState::Starting;
  bool buildingScene = false;
  int scenesBuilt = 0;
  double sceneBuild_ms = 0;  ///< of the last scene, on the clock; 0 before the first
  std::string message;       ///< a sentence, where something failed
};

struct LiveOptions {
  int threads = 0;                    ///< for images; 0: every core but one, which is left to the window
  double sceneMargin_mm = 15;         ///< room to move in a scene, each way; 2..100
  double sceneReserve_mm = 9;         ///< the next scene is begun where less room than this is left
  std::size_t cineBytes = 256 << 20;  ///< memory for frames of the past; the latest frame is kept in any case
  bool background = false;            ///< images come behind the rest of the program: see lowerThreadPriority()
  bool workAhead = true;              ///< compute what scenes to come are made of, as far as processors are idle
  bool keepEnvelopes = false;         ///< LiveFrame::envelope too, about six times the memory
  Physiology physiology = {};         ///< see setPhysiology()
  bool pulsating = false;             ///< see setPulsating()
  bool resting = false;               ///< see setResting()
};

/// A probe over a patient, imaged as it moves. A pose whose face lies inside the skin presses: tissue gives way as the
/// setup's mechanics say, computed before each picture. Owns a thread that makes an image whenever pose or setup have
/// changed, or persistence or tissue have not settled, and a worker that builds the next scene before the probe leaves
/// the present one. A probe that is held still costs nothing. A frame allocates nothing once the cine memory is full.
///
/// Every member may be called from any thread. The destructor waits for the frame in work; a scene that is being built
/// is cancelled.
class LiveImaging {
 public:
  /// Fails on a case without volumes or on differing grids, a setup that is out of range, and a pose that is not rigid.
  static Result<std::unique_ptr<LiveImaging>> make(CaseVolumes patient, const ImagingSetup& setup,
                                                   const Transform& patientFromProbe, const LiveOptions& options = {});
  ~LiveImaging();
  LiveImaging(const LiveImaging&) = delete;
  LiveImaging& operator=(const LiveImaging&) = delete;

  /// The latest pose counts; poses in between are left out. Never blocks. A pose that is not finite and rigid is
  /// ignored.
  void setPose(const Transform& patientFromProbe);

  /// Sets the needle, and the tissue that its tip pushes ahead, from the next frame on; none without a needle. The
  /// latest call counts, and triggers a frame if it differs from the one before. Never blocks. A needle that
  /// validate() refuses, or a dent that is not finite, is ignored.
  void setNeedle(const std::optional<Needle>& needle, const std::optional<Tenting>& tenting = {});

  /// Sets probe, settings, tissues and engine together. Values out of range are refused, and the old setup continues,
  /// as it does until a scene for the new setup is ready. Of several setups in a row, only the last may take effect.
  Result<void> setSetup(const ImagingSetup& setup);

  /// Sets the pressures that act on the patient's blood, from the next frame on. Fails, with a sentence, if out of
  /// range.
  Result<void> setPhysiology(const Physiology& physiology);

  /// Switches pulsation by heart and breath: frames are then made 30 times a second if a vessel is in the plane.
  /// Without it blood is at its mean pressure.
  void setPulsating(bool pulsating);

  /// Sets whether the following frames carry the model's mesh (LivePress::mesh), some hundred kilobytes each.
  void setKeepMesh(bool keep);

  /// Freezes the image: once this returns, latest() and cine() are constant. Poses and setups are kept for later.
  void setFrozen(bool frozen);

  /// While resting, no frames are made, and scenes and their sources (some hundred megabytes) are released. Frames,
  /// pose and setups are kept, and the next frame comes as soon as a scene is built again.
  void setResting(bool resting);

  /// The latest frame; null before the first.
  std::shared_ptr<const LiveFrame> latest() const;

  /// The frames of this long before the latest, oldest first, as far as cineBytes reaches. Empty before the first.
  std::vector<std::shared_ptr<const LiveFrame>> cine(double seconds) const;

  /// Called on the simulation thread after every new frame and every change of state; keep it short. When onFrame
  /// returns, the function given before is not called any more. The function must not call onFrame, and must not
  /// destroy this object.
  void onFrame(std::function<void()> listener);

  /// Images of the last second; 0 for a probe held still.
  double imagesPerSecond() const;
  LiveStatus status() const;

 private:
  class Impl;
  explicit LiveImaging(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
