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

/// Scene and pose to envelope. Not for concurrent use of one object.
class Engine {
 public:
  virtual ~Engine() = default;

  virtual std::string_view name() const = 0;
  /// Note for the user beside the engine's name: the device that it runs on, or the reason why another engine computes
  /// in its place. Empty if there is none.
  virtual std::string_view note() const { return {}; }

  /// Allocates for these settings, which must be valid (see validate()).
  virtual void prepare(const Probe& probe, const ImagingSettings& settings) = 0;

  /// Renders one frame; allocates nothing once `envelope` has its size. `patientFromProbe` is rigid. The same inputs
  /// give the same frame on any number of threads. Uses the calling thread's TBB arena.
  ///
  /// The frame shows the tissue displaced: structures, CT, textures, scatterers and point targets move with it, and so
  /// does the skin. An empty displacement costs nothing. It must be complete (columns times rows shifts), finite and
  /// without folds; tissue from beyond the scene reads as the outermost within.
  ///
  /// `needle`, valid (see validate()), or null: none, which costs nothing. It echoes and casts its shadow at its own
  /// place, independent of the tissue's displacement. Look::Thesis does not draw it.
  virtual void render(const AcousticScene& scene, const Transform& patientFromProbe,
                      const PlaneDisplacement& displacement, const Needle* needle, EnvelopeFrame& envelope) = 0;
  void render(const AcousticScene& scene, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
              EnvelopeFrame& envelope) {
    render(scene, patientFromProbe, displacement, nullptr, envelope);
  }
  /// Renders undisturbed tissue.
  void render(const AcousticScene& scene, const Transform& patientFromProbe, EnvelopeFrame& envelope) {
    render(scene, patientFromProbe, {}, nullptr, envelope);
  }

  struct Stage {
    std::string_view name;
    double ms = 0;  ///< summed over threads
  };
  /// Stages of the last frame.
  virtual const std::vector<Stage>& stages() const = 0;
};

/// Names of the engines: `reference` (scalar, double, to be read), `cpu` (SIMD, threads), `glsl` (a graphics card).
std::vector<std::string> engineNames();
/// One of these, or `auto`: when it is first prepared, it becomes the faster of cpu and glsl, measured once a process,
/// and says which and why; a software renderer is never taken. `glsl` fails with a sentence where there is no
/// OpenGL 4.3.
Result<std::unique_ptr<Engine>> makeEngine(std::string_view name);

/// Schedule of the angles of spatial compounding. A machine sends one angle after the other and averages the last
/// ones: a frame costs as much as without compounding, and moving structures also show where they were. The first
/// frame renders all angles. Stills render all angles in each frame.
enum class CompoundedAngles { InEachFrame, InTurn };

/// Makes the engine for a probe and settings: with spatial compounding, an engine for each angle, else one.
Result<std::unique_ptr<Engine>> makeEngineFor(std::string_view name, const Probe& probe,
                                              const ImagingSettings& settings,
                                              CompoundedAngles angles = CompoundedAngles::InEachFrame);

/// Region that a frame at this pose needs of the scene, where tissue has moved by up to `largestShift_mm` (0 or above).
Region regionOf(const Probe& probe, const ImagingSettings& settings, const Transform& patientFromProbe,
                double largestShift_mm = 0);

}  // namespace insonate
