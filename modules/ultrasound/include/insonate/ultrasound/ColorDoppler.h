#pragma once

#include <insonate/core/Transform.h>
#include <insonate/image/BloodFlow.h>
#include <insonate/image/PlaneDisplacement.h>
#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/ColorSettings.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Expected autocorrelation of the echoes in each sample volume of the color box, after the wall filter, without noise.
/// All values are relative to the power of the receiver's noise. Values of neighboring gates of a scanline are
/// adjacent.
struct ColorFrame {
  int lines = 0, gates = 0;
  std::vector<float> power;               ///< autocorrelation at lag 0, [line][gate]
  std::vector<float> lagOneRe, lagOneIm;  ///< autocorrelation at a lag of one pulse, [line][gate]

  void resize(int newLines, int newGates);
  std::size_t at(int line, int gate) const { return std::size_t(line) * gates + gate; }
};

/// State of blood and tissue for one frame of color.
struct ColorMotion {
  const BloodFlow* blood = nullptr;  ///< velocities of the blood; null: the blood does not move
  /// Velocity of the tissue relative to the probe, probe frame. Fast tissue passes the wall filter and causes flash.
  Vec3 tissue_mmps{};
};

/// Computes color Doppler: for each sample volume, the power and the phase of the echoes of blood and tissue. Blood is
/// what lies inside arteries and veins of the displayed, possibly compressed tissue. One object must not be used
/// concurrently.
class ColorDoppler {
 public:
  virtual ~ColorDoppler() = default;
  virtual std::string_view name() const = 0;

  /// Allocates memory for these settings, which must be valid (see validate()).
  virtual void prepare(const Probe& probe, const ImagingSettings& settings, const ColorSettings& color) = 0;

  /// Computes one frame; allocates nothing once `frame` has its size, if the flow has as many vessels as before. Uses
  /// the calling thread's TBB arena. The same inputs give the same frame on any number of threads.
  virtual void render(const AcousticScene& scene, const Transform& patientFromProbe,
                      const PlaneDisplacement& displacement, const ColorMotion& motion, ColorFrame& frame) = 0;
};

/// Returns the names of the implementations, which are those of engines: `reference` (scalar, double precision, written
/// for readability), `cpu`, and `glsl` (on a graphics card).
std::vector<std::string> colorDopplerNames();
/// Makes an implementation by the name of an engine. `auto` gives the implementation of the engine that `auto` has
/// chosen. Fails if there is no such engine, or if this computer lacks what it needs.
Result<std::unique_ptr<ColorDoppler>> makeColorDoppler(std::string_view name);

}  // namespace insonate
