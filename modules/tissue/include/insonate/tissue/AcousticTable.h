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
  /// Distances of the layer's inner and outer surface from the boundary; from_mm < to_mm.
  double from_mm = 0, to_mm = 0;
  /// echo of the layer where it is perpendicular to the beam; 0 dB is speckle of RMS amplitude 1
  double echo_dB = 0;
  /// Dependence of the echo on the beam's angle, 0 to 1. 0: none; 1: the amplitude decreases as 0.12 + 0.88 cos^2(angle
  /// of incidence).
  double anisotropy = 1;
  double patchiness = 0;  ///< degree to which the layer is interrupted along the boundary, 0 to 1; 0: continuous
  bool operator==(const BoundaryLayer&) const = default;
};

inline constexpr int kMaxBoundaryLayers = 8;

/// Fine structure of a tissue that the CT does not resolve. resources/tissues/README.md describes the textures.
enum class Texture { None, Septa, Lobules, Sheets, Fine, Bundles };

struct AcousticTissue {
  double impedance_MRayl = 1.6;          ///< acoustic impedance; above 0
  double attenuation_dBpcmMHz = 0.7;     ///< one-way attenuation per cm at 1 MHz; at least 0
  double attenuationExponent = 1;        ///< exponent n of the attenuation's growth with frequency, f^n; 0.5 to 2
  double echogenicity_dB = 0;            ///< mean backscatter; 0 dB is speckle of RMS amplitude 1
  double ctImpedancePer100HU = 0;        ///< relative change of impedance per 100 HU above the mean HU of the structure
  double ctEchogenicity_dBper100HU = 0;  ///< change of backscatter per 100 HU above the mean HU of the structure
  double specularExponent = 12;          ///< exponent n of the specular echo's amplitude, cos^n(incidence)
  double specularDiffuse = 0.15;  ///< share of the specular echo's amplitude that falls only as cos(incidence); 0 to 1
  double roughness_dB = 0;        ///< standard deviation of the specular echo along the boundary
  Texture texture = Texture::None;
  /// Strength of the texture, 0 to 40.
  double textureStrength_dB = 0;
  bool vessel = false;  ///< the structure is a vessel: its sides cast edge shadows
  bool gas = false;     ///< the structure contains gas: gas casts dirty shadows, which are filled with reverberation
  std::vector<BoundaryLayer> layers;
  bool operator==(const AcousticTissue&) const = default;
};

/// Acoustic properties by label. Labels that are not in the table have the properties of soft tissue.
struct AcousticTable {
  std::string name;
  std::array<AcousticTissue, kLabelCount> tissues;

  /// Returns the properties of the tissue with this label.
  const AcousticTissue& of(std::uint8_t label) const {
    return tissues[label < kLabelCount ? int{label} : int{kSoftTissue}];
  }
};

/// Returns the names of the presets in resources/tissues, the default ("neck") first.
std::vector<std::string> acousticPresetNames();

/// Loads a preset by name, or a JSON file of the same form by path. A file may name a preset as its "base" and replace
/// single values of it; a file without a base must be complete. Fails with a sentence that names tissue, field, value
/// and allowed range. resources/tissues/README.md describes the form and the ranges.
Result<AcousticTable> loadAcousticTable(std::string_view nameOrPath);
Result<AcousticTable> parseAcousticTable(std::string_view json);

}  // namespace insonate
