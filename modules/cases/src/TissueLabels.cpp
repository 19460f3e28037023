#include <insonate/cases/TissueLabels.h>

#include <tbb/parallel_for.h>

#include <array>
#include <utility>

namespace insonate {

std::optional<LabelMap> withTissueLabels(const OwnLabels& own, const LabelMap& labels) {
  if (own.empty()) return std::nullopt;
  std::array<std::uint8_t, 256> tissue{};
  for (int label = 0; label < 256; ++label) tissue[label] = tissueOf(own, static_cast<std::uint8_t>(label));
  LabelMap map(labels.geometry);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, labels.voxels.size(), 1 << 16), [&](const auto& range) {
    for (std::size_t v = range.begin(); v < range.end(); ++v) map.voxels[v] = tissue[labels.voxels[v]];
  });
  return map;
}

std::shared_ptr<const LabelMap> withTissueLabels(const OwnLabels& own, std::shared_ptr<const LabelMap> labels) {
  auto map = withTissueLabels(own, *labels);
  return map ? std::make_shared<const LabelMap>(std::move(*map)) : labels;
}

void replaceOwnLabels(PatientCase& patient) {
  if (auto map = withTissueLabels(patient.manifest.ownLabels, patient.labels)) patient.labels = std::move(*map);
}

}  // namespace insonate
