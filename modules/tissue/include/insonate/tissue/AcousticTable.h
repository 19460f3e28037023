#pragma once

#include <insonate/core/Result.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A layer of connective tissue (wall, fascia, capsule) along a structure's boundary. Distances are measured from the
/// boundary and are negative inside the structure.
struct BoundaryLayer {
  double from_mm = 0, to_mm = 0;  ///< inner and outer border; from_mm < to_mm
  double echo_dB = 0;             ///< scattering relative to unit speckle, if the layer is perpendicular to the beam
  double anisotropy = 1;          ///< 0: echo independent of angle; 1: amplitude falls as 0.12 + 0.88 cos^2(incidence)
  double patchiness = 0;          ///< 0: even; 1: interrupted along the boundary
  bool operator==(const BoundaryLayer&) const = default;
};

inline constexpr int kMaxBoundaryLayers = 8;

/// Fine structure of a tissue, not resolved by CT.
enum class Texture { None, Septa, Lobules, Sheets, Fine, Bundles };

struct AcousticTissue {
  double impedance_MRayl = 1.6;          ///< above 0
  double attenuation_dBpcmMHz = 0.7;     ///< in dB of amplitude, one way; at least 0
  double attenuationExponent = 1;        ///< exponent of the frequency in MHz, 0.5..2
  double echogenicity_dB = 0;            ///< mean scattering relative to unit speckle
  double ctImpedancePer100HU = 0;        ///< relative change of impedance per 100 HU above the structure's mean
  double ctEchogenicity_dBper100HU = 0;  ///< change of scattering per 100 HU above the structure's mean
  double specularExponent = 12;          ///< exponent n of the specular echo's amplitude, cos^n(incidence)
  double specularDiffuse = 0.15;         ///< share of the amplitude that falls only as cos(incidence), 0..1
  double roughness_dB = 0;  ///< change of the specular echo per SD of the random pattern along the boundary
  Texture texture = Texture::None;
  double textureStrength_dB = 0;
  bool vessel = false;  ///< casts edge shadows
  bool gas = false;     ///< casts dirty shadows: reverberation
  std::vector<BoundaryLayer> layers;
  bool operator==(const AcousticTissue&) const = default;
};

/// Acoustic properties by label. Labels outside the table have the properties of soft tissue.
struct AcousticTable {
  std::string name;
  std::array<AcousticTissue, kLabelCount> tissues;

  const AcousticTissue& of(std::uint8_t label) const {
    return tissues[label < kLabelCount ? int{label} : int{kSoftTissue}];
  }
};

/// Returns the names of the presets in resources/tissues, the default ("neck") first.
std::vector<std::string> acousticPresetNames();

/// Loads a preset by name, or a JSON file of the same form. A file may name a preset as its "base" and override single
/// values; a file without a base must be complete. Fails with a sentence that names tissue, field, value and allowed
/// range; resources/tissues/README.md describes the form and the ranges.
Result<AcousticTable> loadAcousticTable(std::string_view nameOrPath);
Result<AcousticTable> parseAcousticTable(std::string_view json);

}  // namespace insonate
