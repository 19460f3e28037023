#pragma once

#include <insonate/core/Result.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A connective layer that a structure carries at its boundary: wall, fascia, capsule. Distances are signed, from the
/// structure's boundary, negative inside it.
struct BoundaryLayer {
  double from_mm = 0, to_mm = 0;  ///< from < to
  double echo_dB = 0;             ///< scattering relative to unit speckle, where square to the beam
  double anisotropy = 1;          ///< 0: seen from every side, 1: amplitude falls as 0.12 + 0.88 cos^2(incidence)
  double patchiness = 0;          ///< 0: even, 1: comes and goes along the boundary
  bool operator==(const BoundaryLayer&) const = default;
};

inline constexpr int kMaxBoundaryLayers = 8;

/// Structure inside a tissue that a CT does not resolve.
enum class Texture { None, Septa, Lobules, Sheets, Fine, Bundles };

struct AcousticTissue {
  double impedance_MRayl = 1.6;          ///< above 0
  double attenuation_dBpcmMHz = 0.7;     ///< amplitude level, one way; at least 0
  double attenuationExponent = 1;        ///< of the frequency in MHz, 0.5..2
  double echogenicity_dB = 0;            ///< mean scattering relative to unit speckle
  double ctImpedancePer100HU = 0;        ///< relative change of impedance for CT above the structure's mean
  double ctEchogenicity_dBper100HU = 0;  ///< the same for scattering
  double specularExponent = 12;          ///< n of cos^n(incidence), amplitude
  double specularDiffuse = 0.15;         ///< share that falls only as cos(incidence), 0..1
  double roughness_dB = 0;               ///< of the specular echo, per SD of what comes and goes along it
  Texture texture = Texture::None;
  double textureStrength_dB = 0;
  bool vessel = false;  ///< casts edge shadows
  bool gas = false;     ///< casts dirty shadows: reverberation
  std::vector<BoundaryLayer> layers;
  bool operator==(const AcousticTissue&) const = default;
};

/// Acoustic properties by label. Labels that the table does not know read as soft tissue.
struct AcousticTable {
  std::string name;
  std::array<AcousticTissue, kLabelCount> tissues;

  const AcousticTissue& of(std::uint8_t label) const {
    return tissues[label < kLabelCount ? int{label} : int{kSoftTissue}];
  }
};

/// Presets of resources/tissues, the default ("neck") first.
std::vector<std::string> acousticPresetNames();

/// A preset's name or a JSON file of the same form. A file may name a preset as its "base" and override single values;
/// without a base it has to be complete. Fails with a sentence that names tissue, field, value and allowed range; see
/// resources/tissues/README.md for the form and the ranges.
Result<AcousticTable> loadAcousticTable(std::string_view nameOrPath);
Result<AcousticTable> parseAcousticTable(std::string_view json);

}  // namespace insonate
