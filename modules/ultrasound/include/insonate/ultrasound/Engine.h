#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/PlaneDisplacement.h>
#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Frames.h>
#include <insonate/ultrasound/Instruments.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Renders the echo envelope of a scene for a pose of the probe. One object must not be used concurrently.
class Engine {
 public:
  virtual ~Engine() = default;

  virtual std::string_view name() const = 0;
  /// Returns a note to be shown beside the engine's name: the device on which the engine runs, or the reason why
  /// another engine is used instead. Empty if there is no note.
  virtual std::string_view note() const { return {}; }

  /// Allocates memory for these settings, which must be valid (see validate()).
  virtual void prepare(const Probe& probe, const ImagingSettings& settings) = 0;

  /// Renders one frame; allocates nothing once `envelope` has its size. `patientFromProbe` is rigid. The same inputs
  /// give the same frame on any number of threads. Uses the calling thread's TBB arena.
  ///
  /// The frame shows the tissue displaced by `displacement`, including structures, CT, textures, scatterers, point
  /// targets and the skin. An empty displacement takes no computing time. A displacement must be complete (columns
  /// times rows shifts), finite and one-to-one. Where the displacement refers to tissue beyond the scene, the outermost
  /// tissue of the scene is used.
  ///
  /// Needle and rods must be valid (see validate()). The needle's echo and shadow appear at the needle's own position,
  /// independent of the displacement of the tissue; rods and bubbles move with the tissue. Look::Thesis shows no
  /// instruments.
  virtual void render(const AcousticScene& scene, const Transform& patientFromProbe,
                      const PlaneDisplacement& displacement, const Instruments& instruments,
                      EnvelopeFrame& envelope) = 0;
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              EnvelopeFrame& envelope) {
    render(scene, patientFromProbe, displacement, Instruments(), envelope);
  }
  /// Renders tissue that is not displaced.
  void render(const AcousticScene& scene, const Transform& patientFromProbe, EnvelopeFrame& envelope) {
    render(scene, patientFromProbe, {}, Instruments(), envelope);
  }

  /// Makes the next frame independent of the frames before it.
  virtual void forget() {}

  struct Stage {
    std::string_view name;
    double ms = 0;  ///< time of the stage in the last frame, summed over threads
  };
  /// Returns the computing times of the stages of the last frame.
  virtual const std::vector<Stage>& stages() const = 0;
};

/// Returns the names of the engines: `reference` (scalar, double precision, written for readability), `cpu` (SIMD,
/// threads), `glsl` (a graphics card).
std::vector<std::string> engineNames();
/// Makes an engine by name. The engine `auto` uses the faster of cpu and glsl, measured once per process when the
/// engine is first prepared; its note() says which was selected and why. `auto` never selects a software renderer.
/// `glsl` fails with a sentence if OpenGL 4.3 is not available.
Result<std::unique_ptr<Engine>> makeEngine(std::string_view name);

/// Schedule of the angles of spatial compounding. AllAnglesPerFrame: each frame renders all angles; for still images.
/// OneAnglePerFrame: as on a real machine, each frame renders one angle and averages this rendering with the latest
/// renderings of the other angles; the first frame renders all angles. A frame then takes as long as without
/// compounding, but moving structures also appear at their former positions.
enum class CompoundingSchedule { AllAnglesPerFrame, OneAnglePerFrame };

/// Makes an engine by name, as makeEngine() does. If the settings contain spatial compounding, the result combines one
/// such engine for each angle.
Result<std::unique_ptr<Engine>> makeEngineFor(std::string_view name, const Probe& probe,
                                              const ImagingSettings& settings,
                                              CompoundingSchedule angles = CompoundingSchedule::AllAnglesPerFrame);

/// Returns the region that a scene must cover for a frame at this pose. `largestShift_mm`: maximum displacement of
/// tissue, 0 or more.
Region regionOf(const Probe& probe, const ImagingSettings& settings, const Transform& patientFromProbe,
                double largestShift_mm = 0);

}  // namespace insonate
