#include "Checks.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insonate::check {
namespace {

std::string millimetres(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.4g mm", value);
  return text.data();
}

}  // namespace

int headFootAxis(const VolumeGeometry& g) {
  int best = 2;
  for (int a = 0; a < 3; ++a)
    if (std::abs(g.direction.column[a].z) > std::abs(g.direction.column[best].z) + 1e-9) best = a;
  return best;
}

void checkGrid(const CaseView& patient, const LabelStatistics& s, Findings& findings) {
  constexpr double kProbeDepth_mm = 30, kCoarse_mm = 3, kUseless_mm = 10;
  const VolumeGeometry& g = patient.ct.geometry;
  const int fewest = std::min({g.size[0], g.size[1], g.size[2]});
  double shortest_mm = 1e9;
  for (int a = 0; a < 3; ++a) shortest_mm = std::min(shortest_mm, g.size[a] * g.spacing_mm[a]);
  const double coarsest_mm = std::max({g.spacing_mm.x, g.spacing_mm.y, g.spacing_mm.z});
  if (fewest < 3)
    findings.push_back({FindingSeverity::kError, "volume_thin",
                        "The volume has only " + std::to_string(fewest) + (fewest == 1 ? " slice" : " slices") +
                            "; a probe cannot be turned or moved in it. Import a whole series."});
  else if (shortest_mm < kProbeDepth_mm)
    findings.push_back({FindingSeverity::kError, "volume_small",
                        "The volume is only " + millimetres(shortest_mm) + " wide along one axis; a probe's image of " +
                            millimetres(kProbeDepth_mm) + " does not fit into it."});
  if (coarsest_mm > kUseless_mm)
    findings.push_back({FindingSeverity::kError, "spacing_coarse",
                        "Voxels are " + millimetres(coarsest_mm) +
                            " apart along one axis; vessels are smaller. Use a finer reconstruction of the scan."});
  else if (coarsest_mm > kCoarse_mm)
    findings.push_back(
        {FindingSeverity::kWarning, "spacing_coarse",
         "Voxels are " + millimetres(coarsest_mm) + " apart along one axis; structures will look stepped along it."});
  if (s.maxHu - s.minHu < 50)
    findings.push_back({FindingSeverity::kError, "ct_flat",
                        "The CT has values from " + std::to_string(s.minHu) + " to " + std::to_string(s.maxHu) +
                            " HU only, so it cannot show a patient. Check that this is the right CT."});
}

}  // namespace insonate::check
