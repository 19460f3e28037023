#include <insonate/cases/CaseStatistics.h>

#include <algorithm>
#include <string>

namespace insonate {

Result<CaseStatistics> caseStatistics(const CaseView& patient, const Progress& progress) {
  const VolumeGeometry& grid = patient.ct.geometry;
  const std::size_t slice = std::size_t(grid.size[0]) * grid.size[1], count = patient.ct.voxels.size();
  if (count == 0 || count != grid.voxelCount() || patient.labels.voxels.size() != count)
    return fail("The case has no voxels, or not as many labels as voxels. Import the case again.");
  CaseStatistics s;
  s.voxel_mm3 = grid.spacing_mm.x * grid.spacing_mm.y * grid.spacing_mm.z;
  s.min_HU = s.max_HU = patient.ct.voxels.front();
  for (std::size_t first = 0; first < count; first += slice) {
    if (!report(progress, "Measuring the structures", static_cast<double>(first) / static_cast<double>(count)))
      return fail(std::string(kCancelled));
    for (std::size_t v = first; v < first + slice; ++v) {
      const int hu = patient.ct.voxels[v];
      s.min_HU = std::min(s.min_HU, hu);
      s.max_HU = std::max(s.max_HU, hu);
      ++s.histogram[std::size_t(std::clamp(hu, s.kLowest_HU, s.kHighest_HU) - s.kLowest_HU)];
      ++s.voxels[patient.labels.voxels[v]];
    }
  }
  return s;
}

}  // namespace insonate
