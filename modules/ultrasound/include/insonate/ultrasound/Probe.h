#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

enum class ProbeShape { Linear, Curvilinear, Phased };

/// Weights of the elements over the receive aperture: uniform, half of the aperture tapered by a cosine (Tukey), or a
/// full cosine (Hann).
enum class Apodization { Uniform, Tukey, Hann };

/// A transducer. The probe frame has its origin at the center of the face, +x lateral (toward the marker), +z axial
/// (into the body), +y elevation (perpendicular to the image plane). The properties of the array determine the
/// point-spread function (src/model/BeamField.h).
struct Probe {
  std::string name;
  ProbeShape shape = ProbeShape::Linear;
  double width_mm = 38;  ///< linear: length of the array; not used by other shapes
  /// Distance by which the face of the housing extends beyond each end of the array, along the face, before its rounded
  /// end begins. Skin touches this face; the image does not contain the skin there.
  double faceMargin_mm = 2;
  double fovAngle_deg = 60;  ///< curvilinear, phased: full angle alpha of the fan
  double faceRadius_mm = 0;  ///< curvilinear, phased: r1, distance from the virtual apex to the face
  double minFrequency_MHz = 5, maxFrequency_MHz = 13, defaultFrequency_MHz = 7.5;
  double minDepth_mm = 20, maxDepth_mm = 120, defaultDepth_mm = 40;
  double defaultFocus_mm = 20;
  double pitch_mm = 0.2;         ///< center-to-center distance of the elements
  double bandwidth = 0.5;        ///< bandwidth of the received pulse at -6 dB, relative to its frequency
  double transmitFNumber = 2.5;  ///< focal depth divided by the transmit aperture; the operator sets the focus
  double receiveFNumber = 1.5;   ///< depth divided by the receive aperture, which grows with depth
  double maxAperture_mm = 30;    ///< maximum width of the array's active part
  Apodization apodization = Apodization::Tukey;
  double elementHeight_mm = 5;    ///< size of the elements perpendicular to the image plane
  double elevationFocus_mm = 20;  ///< depth of the acoustic lens's focus perpendicular to the image plane
};

/// One numeric field of a probe: its name in probe files, with unit, and the range that validate() accepts.
struct ProbeField {
  enum class Use { Always, Linear, Fan };
  std::string_view name;
  double Probe::*member;
  double low, high;
  Use use = Use::Always;
  bool optional = false;  ///< true: a probe file may omit the field, which then has the default of Probe
};
/// Returns all numeric fields of a probe, in the order of probe files.
std::span<const ProbeField> probeFields();
/// Tells whether probes of this shape have the field.
bool applies(const ProbeField& field, ProbeShape shape);

/// Returns the names of the presets of resources/probes, in a fixed order (linear, curvilinear, phased).
std::vector<std::string> probePresetNames();
/// Loads a preset by name, or a probe file of the same form by path.
Result<Probe> loadProbe(std::string_view nameOrPath);
Result<void> validate(const Probe& probe);
/// Writes a probe file for loadProbe(), atomically. Fails if the probe is out of range or the file cannot be written.
Result<void> saveProbe(const Probe& probe, const std::filesystem::path& file);

}  // namespace insonate
