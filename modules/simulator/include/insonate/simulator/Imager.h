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

/// All settings that decide an image, apart from patient and pose.
struct ImagingSetup {
  Probe probe;
  ImagingSettings settings;
  AcousticTable tissues;
  std::string engine = "auto";  ///< an engine's name from engineNames(), or "auto"
  /// Tells which part of the tissue a scene must cover; an Imager receives the displacement ready-made.
  TissueMechanics mechanics = {};
};

/// One image with its intermediate results.
struct ImagingFrame {
  struct Stage {
    std::string name;
    double ms = 0;  ///< the engine's stages are summed over its threads
  };
  std::uint32_t noiseSeed = 0;  ///< set before render(): frames with different seeds have different electronic noise
  EnvelopeFrame envelope;
  BModeImage image;
  std::vector<Stage> stages;
  double frame_ms = 0;             ///< wall-clock time from pose to image
  std::string engine, engineNote;  ///< engine that computed the image, and its note; see Engine::note()
};

/// Renders images from a scene and a pose: the engine and the display of one setup. Not for concurrent use of one
/// object; uses the calling thread's TBB arena.
class Imager {
 public:
  /// Fails on an unknown engine and on a probe or settings out of range.
  static Result<Imager> make(const ImagingSetup& setup, CompoundedAngles angles = CompoundedAngles::InEachFrame);

  /// Renders an image. Allocates nothing if `frame` has been used before. `patientFromProbe` is rigid (see
  /// ProbePose.h).
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
/// displacement. `further_mm` extends the region to poses that lie up to this much deeper along the axis.
Region sceneRegion(const ImagingSetup& setup, const Transform& patientFromProbe, double further_mm = 0);

/// Splits a path into runs, so that no scene has to cover much more than its frames need.
std::vector<SceneRun> sceneRuns(const ImagingSetup& setup, std::span<const Transform> path, double further_mm = 0);

/// Makes the source of several scenes of one case: parts that the scenes share are computed once. The case must outlive
/// the source.
Result<std::shared_ptr<const SceneSource>> makeSceneSource(const CaseView& patient);

/// Makes the scene of the part of the patient that a region needs. Fails if the region lies outside the patient's
/// volume.
Result<std::shared_ptr<const AcousticScene>> makeScene(const CaseView& patient, const ImagingSetup& setup,
                                                       const Region& region, const Progress& progress = {});
Result<std::shared_ptr<const AcousticScene>> makeScene(const SceneSource& source, const ImagingSetup& setup,
                                                       const Region& region, const Progress& progress = {});

/// Fails with a sentence that names the pose if a frame would lie entirely outside the patient's volume.
Result<void> checkReach(const PatientCase& patient, const ImagingSetup& setup, std::span<const Transform> path);

}  // namespace insonate
