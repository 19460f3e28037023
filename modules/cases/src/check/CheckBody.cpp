#include "Checks.h"
#include "Flood.h"

#include <insonate/tissue/Labels.h>

#include <cmath>
#include <cstdio>
#include <set>

namespace insonate::check {
namespace {

struct Surface {
  std::size_t faces = 0;  ///< between outside air and the body
  std::size_t open = 0;   ///< of these, those whose body side is neither skin nor airway
};

Surface surfaceOf(const LabelMap& labels, const VoxelSet& outside) {
  const VolumeGeometry& g = labels.geometry;
  Surface surface;
  std::size_t v = 0;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i, ++v) {
        if (!outside[v]) continue;
        for (int a = 0; a < 3; ++a)
          for (int step : {-1, 1}) {
            const int x = i + (a == 0 ? step : 0), y = j + (a == 1 ? step : 0), z = k + (a == 2 ? step : 0);
            if (!g.contains(x, y, z)) continue;
            const std::uint8_t label = labels.at(x, y, z);
            if (label == kBackground) continue;
            ++surface.faces;
            surface.open += label != kSkin && label != kAirway;
          }
      }
  return surface;
}

std::set<int> labelsOnSides(const LabelMap& labels, int endAxis) {
  std::set<int> found;
  const auto& size = labels.geometry.size;
  for (int side = 0; side < 3; ++side) {
    if (side == endAxis) continue;
    const int u = (side + 1) % 3, v = (side + 2) % 3;
    for (int a = 0; a < size[u]; ++a)
      for (int b = 0; b < size[v]; ++b)
        for (int face : {0, size[side] - 1}) {
          std::array<int, 3> at;
          at[side] = face, at[u] = a, at[v] = b;
          found.insert(labels.at(at[0], at[1], at[2]));
        }
  }
  found.erase(kBackground);
  return found;
}

std::string percent(double share) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.1f %%", share * 100);
  return text.data();
}

}  // namespace

void checkBody(const CaseView& patient, Findings& findings) {
  const LabelMap& labels = patient.labels;
  const int endAxis = headFootAxis(labels.geometry);
  const VoxelSet outside = floodFromSides(labels, kBackground, endAxis);

  const Surface surface = surfaceOf(labels, outside);
  const double open = surface.faces ? static_cast<double>(surface.open) / static_cast<double>(surface.faces) : 0;
  if (open > 0.01)
    findings.push_back({FindingSeverity::kWarning, "skin_open",
                        percent(open) + " of the body's surface has no skin. Probe and needle would meet other tissue "
                                        "there. Label the skin there."});

  std::size_t enclosed = 0, last = 0;
  for (std::size_t v = 0; v < outside.size(); ++v) {
    if (labels.voxels[v] != kBackground || outside[v]) continue;
    ++enclosed, last = v;
  }
  const double enclosed_ml = static_cast<double>(enclosed) * voxelVolume_mm3(labels.geometry) / 1000;
  if (enclosed > 0)
    findings.push_back({enclosed_ml > 1 ? FindingSeverity::kWarning : FindingSeverity::kInfo, "background_inside",
                        std::to_string(enclosed) + " background voxels (" + std::to_string(std::lround(enclosed_ml)) +
                            " ml) are enclosed by the body and will look like air in the image. Label them, for "
                            "example as soft tissue.",
                        placeOf(labels.geometry, last)});

  std::string cut;
  for (int label : labelsOnSides(labels, endAxis)) cut += (cut.empty() ? "" : ", ") + labelName(label);
  if (!cut.empty())
    findings.push_back(
        {FindingSeverity::kInfo, "cut_at_side",
         "The body is cut off by the sides of the volume (" + cut + "); images end there, and there is no skin."});
}

}  // namespace insonate::check
