#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>
#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>
#include <insonate/ultrasound/Needle.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Renders the echo envelope of a scene for a pose of the probe. Not for concurrent use of one object.
class Engine {
 public:
  virtual ~Engine() = default;

  virtual std::string_view name() const = 0;
  /// Returns a note that the user sees beside the engine's name: the device on which the engine runs, or the reason why
  /// another engine computes instead. Empty if there is no note.
  virtual std::string_view note() const { return {}; }

  /// Allocates memory for these settings, which must be valid (see validate()).
  virtual void prepare(const Probe& probe, const ImagingSettings& settings) = 0;

  /// Renders one frame; allocates nothing once `envelope` has its size. `patientFromProbe` is rigid. The same inputs
  /// give the same frame on any number of threads. Uses the calling thread's TBB arena.
  ///
  /// The frame shows displaced tissue: structures, CT, textures, scatterers, point targets and the skin move with it.
  /// An empty displacement has no cost. A displacement must be complete (columns times rows shifts), finite and without
  /// folds; tissue from beyond the scene reads as the outermost tissue of the scene.
  ///
  /// `needle` is valid (see validate()), or null for no needle, which has no cost. The needle echoes and casts its
  /// shadow at its own place, independent of the tissue's displacement. Look::Thesis does not draw the needle.
  virtual void render(const AcousticScene& scene, const Transform& patientFromProbe,
                      const PlaneDisplacement& displacement, const Needle* needle, EnvelopeFrame& envelope) = 0;
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              EnvelopeFrame& envelope) {
    render(scene, patientFromProbe, displacement, nullptr, envelope);
  }
  /// Renders tissue that is not displaced.
  void render(const AcousticScene& scene, const Transform& patientFromProbe, EnvelopeFrame& envelope) {
    render(scene, patientFromProbe, {}, nullptr, envelope);
  }

  struct Stage {
    std::string_view name;
    double ms = 0;  ///< time of the stage in the last frame, summed over threads
  };
  /// Returns the times of the last frame's stages of computation.
  virtual const std::vector<Stage>& stages() const = 0;
};

/// Returns the names of the engines: `reference` (scalar, double precision, written for readability), `cpu` (SIMD,
/// threads), `glsl` (a graphics card).
std::vector<std::string> engineNames();
/// Makes an engine by name. The engine `auto` uses the faster of cpu and glsl, measured once per process when the
/// engine is first prepared; its note() says which was selected and why. `auto` never selects a software renderer.
/// `glsl` fails with a sentence if OpenGL 4.3 is not available.
Result<std::unique_ptr<Engine>> makeEngine(std::string_view name);

/// Schedule of the angles of spatial compounding. OneAnglePerFrame: as on a machine, each frame transmits one angle and
/// averages the last angles. A frame then costs as much as without compounding, and moving structures also show at
/// earlier places; the first frame renders all angles. AllAnglesPerFrame: each frame renders all angles, for still
/// images.
enum class CompoundingSchedule { AllAnglesPerFrame, OneAnglePerFrame };

/// Makes the engine for a probe and settings: with spatial compounding, one engine for each angle, else a single
/// engine.
Result<std::unique_ptr<Engine>> makeEngineFor(std::string_view name, const Probe& probe,
                                              const ImagingSettings& settings,
                                              CompoundingSchedule angles = CompoundingSchedule::AllAnglesPerFrame);

/// Returns the region that a scene must cover for a frame at this pose if tissue is displaced by up to
/// `largestShift_mm` (0 or above).
Region regionOf(const Probe& probe, const ImagingSettings& settings, const Transform& patientFromProbe,
                double largestShift_mm = 0);

}  // namespace insonate
