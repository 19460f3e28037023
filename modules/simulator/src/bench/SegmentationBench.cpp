#include "SegmentationParts.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/SegmentationBench.h>

namespace insonate {
namespace {

constexpr double kUsualNoise_HU = 10, kStrongNoise_HU = 30;

std::vector<bench::NeckScan> scans(bool quick) {
  std::vector<bench::NeckScan> all;
  for (const PhantomVariant& variant : phantomVariants()) {
    for (const CtContrast contrast : {CtContrast::kNative, CtContrast::kArterial})
      all.push_back({std::string(variant.name), contrast, kUsualNoise_HU});
    if (quick) break;
    if (&variant == &phantomVariants().front())
      for (const CtContrast contrast : {CtContrast::kNative, CtContrast::kArterial})
        all.push_back({std::string(variant.name), contrast, kStrongNoise_HU});
  }
  return all;
}

}  // namespace

Result<SegmentationBench> runSegmentationBench(bool quick, const Progress& progress) {
  SegmentationBench result;
  const auto todo = scans(quick);
  double done = 0;
  const double parts = double(todo.size()) + (quick ? 0 : 4);
  const Progress part = [&](std::string_view doing, double fraction) {
    return report(progress, doing, (done + fraction) / parts);
  };
  for (const bench::NeckScan& scan : todo) {
    const auto rows = bench::scoreNeck(scan, part);
    if (!rows) return tl::unexpected(rows.error());
    result.rows.insert(result.rows.end(), rows->begin(), rows->end());
    ++done;
  }
  result.notes.emplace_back("Clicks lie on the middle of a vessel of the truth, evenly from end to end.");
  if (quick) return result;
  auto times = bench::timeTools({512, 512, 300}, part);
  if (!times) return tl::unexpected(times.error());
  result.times = std::move(*times);
  return result;
}

}  // namespace insonate
