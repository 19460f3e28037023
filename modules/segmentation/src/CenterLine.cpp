#include "VesselTracer.h"

#include <insonate/segmentation/CenterLine.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace insonate {
namespace {

double squaredDistance_mm2(Vec3 point, Vec3 from, Vec3 to) {
  const Vec3 way = to - from, off = point - from;
  const double along = std::clamp(dot(off, way) / std::max(dot(way, way), 1e-12), 0.0, 1.0);
  const Vec3 rest = off - way * along;
  return dot(rest, rest);
}

}  // namespace

Result<std::vector<CenterLine>> centerLines(const LabelMap& labels, std::uint8_t label, const Progress& progress) {
  const VolumeGeometry& g = labels.geometry;
  if (auto ok = validate(g); !ok) return tl::unexpected(ok.error());
  segmentation::VesselTracer tracer(labels, label);
  std::vector<CenterLine> lines;
  // From the middle slice to both ends, since a line starts most reliably far from the volume's edge.
  for (const bool evenCut : {false, true}) {
    for (int n = 0; n < g.size[2]; ++n) {
      const int k = g.size[2] / 2 + (n % 2 ? -(n + 1) / 2 : n / 2);
      if (!report(progress, "Finding the middle of the vessels", (n + evenCut * g.size[2]) / (2.0 * g.size[2])))
        return fail(std::string(kCancelled));
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i) {
          if (labels.at(i, j, k) != label || !tracer.isOpen(g.offset(i, j, k))) continue;
          if (CenterLine line = tracer.trace(i, j, k, evenCut); !line.empty()) lines.push_back(std::move(line));
        }
    }
    tracer.reopen();
  }
  return lines;
}

std::optional<double> distanceToCenterLine_mm(std::span<const CenterLine> lines, Vec3 patient_mm) noexcept {
  std::optional<double> min_mm2;
  for (const CenterLine& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double mm2 = squaredDistance_mm2(patient_mm, line[i - 1], line[i]);
      if (!min_mm2 || mm2 < *min_mm2) min_mm2 = mm2;
    }
  if (min_mm2) min_mm2 = std::sqrt(*min_mm2);
  return min_mm2;
}

}  // namespace insonate
