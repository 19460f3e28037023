#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>

#include <cstdint>

namespace insonate {

/// Iodine in the vessels: none (kNative), or an arterial phase with early venous return (kArterial).
enum class CtContrast { kNative, kArterial };

struct CtSynthesisOptions {
  std::uint32_t seed = 1;
  CtContrast contrast = CtContrast::kNative;
  double noise_HU = 10;             ///< standard deviation of the scanner's noise; 0 to 200
  double resolution_FWHM_mm = 0.9;  ///< full width at half maximum of the scanner's blur; 0 to 5
};

/// Synthesizes a CT (HU, int16) for a label map (labels of insonate/tissue/Labels.h) on any grid. The CT has a mean HU
/// and a smooth texture for each label, compact bone around trabecular bone, the partial-volume effect (by a Gaussian
/// blur) and slightly correlated noise. Uses all cores. The same labels and options give identical bytes on any number
/// of threads. Fails on options outside their range, an invalid grid, and when cancelled.
Result<CtVolume> synthesizeCt(const LabelMap& labels, const CtSynthesisOptions& options, const Progress& progress = {});

}  // namespace insonate
