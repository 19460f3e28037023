#pragma once

#include <insonate/cases/CaseView.h>
#include <insonate/core/Progress.h>
#include <insonate/simulator/TissueMechanics.h>
#include <insonate/tissue/AcousticTable.h>
#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/ColorDisplay.h>
#include <insonate/ultrasound/Display.h>
#include <insonate/ultrasound/Engine.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// All settings that determine an ultrasound image, except patient and pose.
struct ImagingSetup {
  Probe probe;
  ImagingSettings settings;
  AcousticTable tissues;
  std::string engine = "auto";  ///< an engine's name from engineNames(), or "auto"
  /// Mechanical model of the tissue. It determines the extent of the tissue that a scene must cover. Imager::render()
  /// does not use the model; the caller passes the computed displacement.
  TissueMechanics mechanics = {};
  std::optional<ColorSettings> color = {};  ///< color Doppler; empty: off
};

/// One image with its intermediate results.
struct ImagingFrame {
  struct Stage {
    std::string name;
    double ms = 0;  ///< computing time; of engine stages, the sum over all threads
  };
  std::uint32_t noiseSeed = 0;  ///< seed of the electronic noise; set it before render()
  /// Motion of blood and tissue, for color Doppler; set it before render(). Not used without ImagingSetup::color.
  ColorMotion motion;
  EnvelopeFrame envelope;
  BModeImage image;
  ColorImage color;  ///< empty without ImagingSetup::color
  std::vector<Stage> stages;
  double frame_ms = 0;             ///< wall-clock time of the whole image, from pose to B-mode
  std::string engine, engineNote;  ///< name of the engine that computed the image, and Engine::note()
};

/// Renders ultrasound images from a scene and a probe pose, with one engine (echoes) and display (B-mode processing),
/// and color Doppler if the setup has it. One object must not be used concurrently; uses the calling thread's TBB
/// arena.
class Imager {
 public:
  /// Makes an imager for a setup. Fails on an unknown engine, and on a probe or settings out of range.
  static Result<Imager> make(const ImagingSetup& setup,
                             CompoundingSchedule angles = CompoundingSchedule::AllAnglesPerFrame);

  /// Renders an image of undeformed tissue without a needle. Allocates nothing if `frame` has been used before.
  /// `patientFromProbe` is rigid (see ProbePose.h).
  void render(const AcousticScene& scene, const Transform& patientFromProbe, ImagingFrame& frame) {
    render(scene, patientFromProbe, {}, Instruments(), frame);
  }
  /// Renders an image of displaced tissue with needle, guidewires and catheters; see Engine.h.
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const Instruments& instruments, ImagingFrame& frame);

  /// Makes the next image independent of the images before it: without their persistence and their angles.
  void forget();

 private:
  struct Color {
    std::unique_ptr<ColorDoppler> doppler;
    ColorDisplay display;
    ColorFrame frame;
  };
  Imager(std::unique_ptr<Engine> engine, Display display) : engine_(std::move(engine)), display_(std::move(display)) {}
  void renderColor(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
                   ImagingFrame& frame);

  std::unique_ptr<Engine> engine_;
  Display display_;
  std::optional<Color> color_;
};

/// Consecutive poses of a path that share one acoustic scene: the poses `first` to `first` + `count` - 1. The scene
/// covers `region`.
struct SceneRun {
  Region region;
  std::size_t first = 0, count = 0;
};

/// Returns the region that a scene must cover for an image at this pose, including tissue outside the image that
/// affects its displacement. `further_mm` extends the region for poses up to this much deeper along the probe's axis.
Region sceneRegion(const ImagingSetup& setup, const Transform& patientFromProbe, double further_mm = 0);

/// Splits a path of probe poses into runs of consecutive poses whose images can share one scene, so that no scene
/// covers much more than its images need.
std::vector<SceneRun> sceneRuns(const ImagingSetup& setup, std::span<const Transform> path, double further_mm = 0);

/// Makes the SceneSource of a case: precomputed data that all acoustic scenes of the case share. The case must outlive
/// the source.
Result<std::shared_ptr<const SceneSource>> makeSceneSource(const CaseView& patient);

/// Makes the scene of a region of the patient. Fails if the region lies outside the patient's volume.
Result<std::shared_ptr<const AcousticScene>> makeScene(const CaseView& patient, const ImagingSetup& setup,
                                                       const Region& region, const Progress& progress = {});
/// Makes the scene of a region. `quality`: live images may use a coarse scene; all others need full quality.
Result<std::shared_ptr<const AcousticScene>> makeScene(const SceneSource& source, const ImagingSetup& setup,
                                                       const Region& region, const Progress& progress = {},
                                                       SceneQuality quality = SceneQuality::Full);

/// Fails with a sentence that names the pose if the image at any pose of `path` would lie entirely outside the
/// patient's volume.
Result<void> checkPosesTouchVolume(const PatientCase& patient, const ImagingSetup& setup,
                                   std::span<const Transform> path);

}  // namespace insonate
