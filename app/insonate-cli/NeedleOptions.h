#pragma once

#include <insonate/core/Result.h>
#include <insonate/simulator/Tenting.h>
#include <insonate/ultrasound/Needle.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <vector>

namespace insonate::cli {

/// Command-line options for a needle, in the probe's frame: the needle moves with the probe along a path of poses.
struct NeedleOptions {
  std::vector<double> tip_mm, direction{1, 0, 1}, bevel;
  double diameter_mm = 1.27, length_mm = 70, tenting_mm = 0, tentingRadius_mm = 3;

  void addTo(CLI::App& command);
};

/// A needle and its tenting (tissue that its tip pushes ahead), as given by the command line, checked; probe frame.
struct NeedlePlan {
  std::optional<Needle> needle;
  std::optional<Tenting> tenting;

  /// Returns the needle in the patient's frame (LPS); `needle` must have a value.
  Needle needleAt(const Transform& patientFromProbe) const;
  /// Returns the displacement `pressed` by the probe plus that by the needle's tip. Valid until the next call.
  const PlaneDisplacement& dented(const PlaneDisplacement& pressed, TentedTissue& tissue,
                                  const Transform& patientFromProbe) const;
};

Result<NeedlePlan> readNeedle(const NeedleOptions& options);

}  // namespace insonate::cli
