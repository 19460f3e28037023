#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace insonate {

/// A probe file as it is, or one that states widths of the beam, as files did until November 2026, by the array that
/// has these widths. Recordings and saved probes hold such files. `trouble` is set by one that is neither.
///
/// With the pulse's length p, the width w at the focus and the slice's t, all in wavelengths, and the lens at z:
/// bandwidth 0.441 / p (a Gaussian); receive F-number w / 1.733 and transmit F-number twice that, Hann (the law of
/// lateralFwhm_mm()); height 0.98 z / t (a strip at its focus); the pitch of the built-in probe of its shape. How fast
/// the former beam grew off its foci is left out: the array says it.
nlohmann::json withFormerNames(const nlohmann::json& file, const std::string& where, std::string& trouble);

}  // namespace insonate
