#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

enum class ProbeShape { Linear, Curvilinear, Phased };

/// Weights of the elements over the receive aperture: all alike, half of them tapered by a cosine, or a whole cosine.
enum class Apodization { Uniform, Tukey, Hann };

/// A transducer. Its frame: origin at the center of the face, +x lateral (toward the marker), +z axial (into the body),
/// +y elevation. The point-spread function is that of the array: see src/model/BeamField.h.
struct Probe {
  std::string name;
  ProbeShape shape = ProbeShape::Linear;
  double width_mm = 38;      ///< linear: length of the array
  double fovAngle_deg = 60;  ///< curvilinear, phased: full angle alpha of the fan
  double faceRadius_mm = 0;  ///< curvilinear, phased: r1, from the virtual apex to the face
  double minFrequency_MHz = 5, maxFrequency_MHz = 13, defaultFrequency_MHz = 7.5;
  double minDepth_mm = 20, maxDepth_mm = 120, defaultDepth_mm = 40;
  double defaultFocus_mm = 20;
  double pitch_mm = 0.2;         ///< of the elements, center to center
  double bandwidth = 0.5;        ///< of the pulse that comes back, at -6 dB, over its frequency
  double transmitFNumber = 2.5;  ///< focus over aperture; the focus is the operator's
  double receiveFNumber = 1.5;   ///< depth over aperture, which follows the depth
  double maxAperture_mm = 30;    ///< largest active part of the array
  Apodization apodization = Apodization::Tukey;
  double elementHeight_mm = 5;    ///< across the imaging plane
  double elevationFocus_mm = 20;  ///< of the lens
};

/// One number of a probe: its name, with its unit, as in probe files, and the least and most that validate() accepts.
struct ProbeField {
  enum class Use { Always, Linear, Fan };
  std::string_view name;
  double Probe::*member;
  double low, high;
  Use use = Use::Always;
};
/// All numbers, in the order of probe files.
std::span<const ProbeField> probeFields();
/// Tells whether a probe of this shape has the field.
bool applies(const ProbeField& field, ProbeShape shape);

/// The presets of resources/probes, in a fixed order (linear, curvilinear, phased).
std::vector<std::string> probePresetNames();
/// A preset's name, or a path to a probe file of the same form.
Result<Probe> loadProbe(std::string_view nameOrPath);
Result<void> validate(const Probe& probe);
/// Writes a probe file that loadProbe() reads, atomically. Fails on a probe out of range and where it cannot write.
Result<void> saveProbe(const Probe& probe, const std::filesystem::path& file);

}  // namespace insonate
