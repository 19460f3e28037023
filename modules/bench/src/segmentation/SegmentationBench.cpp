#include "SegmentationParts.h"

#include <insonate/bench/SegmentationBench.h>
#include <insonate/cases/CaseFromLabels.h>
#include <insonate/cases/Phantom.h>

#include <array>
#include <functional>

namespace insonate {
namespace {

using bench::ScoreRows;

constexpr std::array kNoises_HU{0.0, 10.0, 20.0, 40.0};
constexpr std::array kQuickNoises_HU{10.0};
/// Blur of the built-in necks (a sharp kernel) and of the atlas (a soft kernel): voxels of the atlas are twice as
/// large, and those on borders contain both tissues.
constexpr double kNeckBlur_mm = 0.9, kAtlasBlur_mm = 1.5;

using Part = std::function<Result<void>(SegmentationBench&, const Progress&)>;

Result<void> added(SegmentationBench& bench, const Result<ScoreRows>& rows) {
  if (!rows) return tl::unexpected(rows.error());
  bench.rows.insert(bench.rows.end(), rows->begin(), rows->end());
  return {};
}

std::span<const double> noisesOf(bool quick) {
  return quick ? std::span<const double>(kQuickNoises_HU) : kNoises_HU;
}

Part neckPart(const std::string& variant, bool quick) {
  return [=](SegmentationBench& bench, const Progress& progress) -> Result<void> {
    const auto patient = makePhantom(variant, 1, progress);
    if (!patient) return tl::unexpected(patient.error());
    return added(bench, bench::scoreTruth(*patient, variant, noisesOf(quick), kNeckBlur_mm, progress));
  };
}

Part atlasPart(const SegmentationBenchPlan& plan) {
  return [=](SegmentationBench& bench, const Progress& progress) -> Result<void> {
    const auto atlas = caseFromLabels(plan.atlas, plan.atlasMap, {}, progress);
    if (!atlas) return tl::unexpected(atlas.error());
    return added(bench, bench::scoreTruth(atlas->patient, "atlas", noisesOf(plan.quick), kAtlasBlur_mm, progress));
  };
}

std::vector<Part> partsOf(const SegmentationBenchPlan& plan) {
  std::vector<Part> parts;
  if (!plan.chestCta.empty())
    parts.push_back([folder = plan.chestCta](SegmentationBench& bench, const Progress& progress) {
      return added(bench, bench::scoreChestCta(folder, progress));
    });
  if (!plan.atlas.empty()) parts.push_back(atlasPart(plan));
  for (const std::string& neck : plan.necks) parts.push_back(neckPart(neck, plan.quick));
  if (plan.automatic)
    parts.push_back([quick = plan.quick](SegmentationBench& bench, const Progress& progress) {
      return bench::scoreAutomaticStructures(quick, bench, progress);
    });
  if (plan.speed)
    parts.push_back([](SegmentationBench& bench, const Progress& progress) {
      return bench::timeTools({512, 512, 300}, bench, progress);
    });
  return parts;
}

}  // namespace

Result<SegmentationBench> runSegmentationBench(const SegmentationBenchPlan& plan, const Progress& progress) {
  SegmentationBench result;
  result.notes.emplace_back("Clicks lie on the middle of a vessel of the truth, evenly from end to end.");
  const std::vector<Part> parts = partsOf(plan);
  double done = 0;
  for (const Part& part : parts) {
    const Progress ofAll = [&](std::string_view doing, double fraction) {
      return report(progress, doing, (done + fraction) / double(parts.size()));
    };
    if (auto ok = part(result, ofAll); !ok) return tl::unexpected(ok.error());
    ++done;
  }
  return result;
}

}  // namespace insonate
