#pragma once

#include <insonate/cases/CaseView.h>
#include <insonate/core/Progress.h>
#include <insonate/simulator/TissueMechanics.h>
#include <insonate/tissue/AcousticTable.h>
#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/Display.h>
#include <insonate/ultrasound/Engine.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// Everything but patient and pose that decides what an image looks like.
struct ImagingSetup {
  Probe probe;
  ImagingSettings settings;
  AcousticTable tissues;
  std::string engine = "auto";     ///< or one of engineNames()
  TissueMechanics mechanics = {};  ///< for what presses: an Imager is handed the displacement
};

/// One image with what led to it.
struct ImagingFrame {
  struct Stage {
    std::string name;
    double ms = 0;  ///< the engine's are summed over threads
  };
  std::uint32_t noiseSeed = 0;  ///< set before render(): frames of other seeds have other electronic noise
  EnvelopeFrame envelope;
  BModeImage image;
  std::vector<Stage> stages;
  double frame_ms = 0;             ///< from pose to image, on the clock
  std::string engine, engineNote;  ///< that computed it, and what is to be said of it; see Engine::note()
};

/// Renders images from a scene and a pose: the engine and the display of one setup. Not for concurrent use of one
/// object; uses the calling thread's TBB arena.
class Imager {
 public:
  /// Fails on an unknown engine and on a probe or settings out of range.
  static Result<Imager> make(const ImagingSetup& setup, CompoundedAngles angles = CompoundedAngles::InEachFrame);

  /// Allocates nothing once `frame` has been used before. `patientFromProbe` is rigid (see ProbePose.h).
  void render(const AcousticScene& scene, const Transform& patientFromProbe, ImagingFrame& frame) {
    render(scene, patientFromProbe, {}, nullptr, frame);
  }
  /// Renders displaced tissue, with a needle unless it is null; see Engine.h.
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              const Needle* needle, ImagingFrame& frame);

 private:
  Imager(std::unique_ptr<Engine> engine, Display display) : engine_(std::move(engine)), display_(std::move(display)) {}
  std::unique_ptr<Engine> engine_;
  Display display_;
};

/// Consecutive poses that share one scene.
struct SceneRun {
  Region region;
  std::size_t first = 0, count = 0;
};

/// Region that a scene must cover for a frame at this pose, including displaced tissue and the tissue that decides its
/// displacement. `further_mm` adds poses that lie deeper along the axis by up to as much.
Region sceneRegion(const ImagingSetup& setup, const Transform& patientFromProbe, double further_mm = 0);

/// Splits a path so that no scene has to cover much more than its frames need.
std::vector<SceneRun> sceneRuns(const ImagingSetup& setup, std::span<const Transform> path, double further_mm = 0);

/// Makes the source of scenes for a case with more than one scene: shared parts are computed once. It must not outlive
/// the case.
Result<std::shared_ptr<const SceneSource>> makeSceneSource(const CaseView& patient);

/// The part of the patient that a region needs. Fails on a region that misses the patient's volume.
Result<std::shared_ptr<const AcousticScene>> makeScene(const CaseView& patient, const ImagingSetup& setup,
                                                       const Region& region, const Progress& progress = {});
Result<std::shared_ptr<const AcousticScene>> makeScene(const SceneSource& source, const ImagingSetup& setup,
                                                       const Region& region, const Progress& progress = {});

/// Fails, naming the pose, where a frame would miss the patient's volume altogether.
Result<void> checkReach(const PatientCase& patient, const ImagingSetup& setup, std::span<const Transform> path);

}  // namespace insonate
