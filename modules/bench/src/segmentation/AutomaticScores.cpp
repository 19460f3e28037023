#include "SegmentationParts.h"
#include "WarpedNeck.h"

#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/CenterLine.h>
#include <insonate/segmentation/Score.h>
#include <insonate/simulator/NeckAtlas.h>
#include <insonate/tissue/Labels.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace insonate::bench {
namespace {

constexpr double kFilledBar = 0.90, kNativeBar = 0.80, kTissueBar = 0.85;
constexpr double kRightDice = 0.7, kRightCenter_mm = 2;
constexpr double kEnd_mm = 2;  // at each end of a vessel, not scored

struct TestNeck {
  std::string variant;
  NeckWarp warp;
  CtContrast contrast;
  double noise_HU;
};

/// Necks that the atlas does not contain, warped beyond the differences of built-in necks.
std::vector<TestNeck> testNecks(bool quick) {
  constexpr auto kPlain = CtContrast::kNative, kFilled = CtContrast::kArterial;
  std::vector<TestNeck> necks{
      {"textbook", {.seed = 1}, kPlain, 10},
      {"small-vein",
       {.seed = 7, .scale = 1.15, .turn_deg = {8, -6, 10}, .isMirrored = true, .bend_mm = 6},
       kFilled,
       10},
      {"collapsed-vein", {.seed = 10, .scale = 1.05, .turn_deg = {-5, 8, -7}, .bend_mm = 7}, kPlain, 10},
      {"vein-over-artery",
       {.seed = 11, .scale = 0.95, .turn_deg = {10, -5, 10}, .isMirrored = true, .bend_mm = 7},
       kFilled,
       20},
      {"low-bifurcation", {.seed = 8, .scale = 0.87, .turn_deg = {-12, 5, -12}, .bend_mm = 8}, kPlain, 20},
      {"head-turned", {.seed = 9, .turn_deg = {5, 3, 0}, .bend_mm = 5}, kPlain, 10},
      {"deep-in-fat",
       {.seed = 12, .scale = 0.9, .turn_deg = {10, -5, -14}, .isMirrored = true, .bend_mm = 8},
       kPlain,
       10},
      {"high-bifurcation",
       {.seed = 13, .scale = 1.2, .turn_deg = {-8, -8, 12}, .bend_mm = 8, .spacing_mm = {0.8, 0.8, 3}},
       kPlain,
       20},
      {"large-sternomastoid",
       {.seed = 14, .scale = 1.1, .turn_deg = {12, 0, 6}, .bend_mm = 8, .spacing_mm = {0.7, 0.7, 2}},
       kFilled,
       0}};
  if (quick) necks.resize(2);
  return necks;
}

struct Range {
  double low_mm = -std::numeric_limits<double>::max(), high_mm = std::numeric_limits<double>::max();
  bool contains(double z_mm) const { return z_mm >= low_mm && z_mm <= high_mm; }
};

const NamedVessel& vesselNamed(const WarpedNeck& neck, std::string_view name) {
  return *std::ranges::find(neck.vessels, name, &NamedVessel::name);
}

/// Levels at which a vessel exists and was found; all levels for another structure.
std::array<Range, kNeckStructures> rangesOf(const WarpedNeck& truth, const std::vector<ProposedStructure>& found) {
  std::array<Range, kNeckStructures> ranges;
  for (std::size_t n = 0; n < kNeckVessels; ++n) {
    const auto& course = vesselNamed(truth, nameOf(found[n].structure)).course;
    const auto [a, b] = std::ranges::minmax(course, {}, [](const auto& point) { return point.position_mm.z; });
    ranges[n] = {a.position_mm.z + kEnd_mm, b.position_mm.z - kEnd_mm};
    if (found[n].line.empty()) continue;
    const auto [c, d] = std::ranges::minmax(found[n].line, {}, [](Vec3 point) { return point.z; });
    ranges[n].low_mm = std::max(ranges[n].low_mm, c.z + kEnd_mm);
    ranges[n].high_mm = std::min(ranges[n].high_mm, d.z - kEnd_mm);
  }
  return ranges;
}

/// Structure to which a voxel of the reference belongs; empty if it is none of those that are proposed.
std::optional<NeckStructure> structureAt(const WarpedNeck& truth, std::uint8_t label, Vec3 at_mm) {
  if (label == kThyroid) return NeckStructure::Thyroid;
  if (label == kSternocleidomastoid) {
    const double right = distanceToCenterLine_mm(vesselNamed(truth, nameOf(NeckStructure::RightJugular)), at_mm);
    const double left = distanceToCenterLine_mm(vesselNamed(truth, nameOf(NeckStructure::LeftJugular)), at_mm);
    return right < left ? NeckStructure::RightSternocleidomastoid : NeckStructure::LeftSternocleidomastoid;
  }
  if (label != kVein && label != kArtery) return std::nullopt;
  const NamedVessel* nearest = nullptr;
  double least_mm = std::numeric_limits<double>::max();
  for (const NamedVessel& vessel : truth.vessels)
    if (const double away_mm = distanceToWall_mm(vessel, at_mm); vessel.label == label && away_mm < least_mm)
      nearest = &vessel, least_mm = away_mm;
  for (std::size_t n = 0; nearest && n < kNeckVessels; ++n)
    if (nearest->name == nameOf(static_cast<NeckStructure>(n))) return static_cast<NeckStructure>(n);
  return std::nullopt;
}

/// Numbers the structures from 1 on, in both maps.
struct Maps {
  LabelMap found, truth;
};

Maps mapsOf(const WarpedNeck& truth, const std::vector<ProposedStructure>& found) {
  const VolumeGeometry& g = truth.labels.geometry;
  Maps maps{LabelMap(g), LabelMap(g)};
  const auto ranges = rangesOf(truth, found);
  const Transform patientFromIndex = g.patientFromIndex();
  tbb::parallel_for(0, g.size[2], [&](int k) {
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Vec3 at_mm = patientFromIndex * Vec3{double(i), double(j), double(k)};
        for (std::size_t n = 0; n < kNeckStructures; ++n)
          if (ranges[n].contains(at_mm.z) && found[n].voxels.isSelected(i, j, k))
            maps.found.at(i, j, k) = static_cast<std::uint8_t>(n + 1);
        const auto structure = structureAt(truth, truth.labels.at(i, j, k), at_mm);
        if (structure && ranges[std::size_t(*structure)].contains(at_mm.z))
          maps.truth.at(i, j, k) = static_cast<std::uint8_t>(std::size_t(*structure) + 1);
      }
  });
  return maps;
}

/// Mean distance of the true center line from the line that was found, at the levels that are scored.
std::optional<double> centerError_mm(const NamedVessel& truth, const CenterLine& line, const Range& range) {
  double sum = 0, count = 0;
  for (const NamedVessel::Point& point : truth.course)
    if (range.contains(point.position_mm.z) && !line.empty())
      sum += *distanceToCenterLine_mm(std::array{line}, point.position_mm), count += 1;
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

Result<void> scoreNeck(const TestNeck& test, const std::vector<AtlasNeck>& atlas, ScoreRows& rows,
                       const Progress& progress) {
  const auto truth = warpedNeck(test.variant, test.warp, progress);
  if (!truth) return tl::unexpected(truth.error());
  const auto ct =
      synthesizeCt(truth->labels, {.seed = 5, .contrast = test.contrast, .noise_HU = test.noise_HU}, progress);
  if (!ct) return tl::unexpected(ct.error());
  const auto automatic = autoLabel(*ct, progress);
  if (!automatic) return tl::unexpected(automatic.error());
  const auto found = proposeNeck(*ct, *automatic, atlas, progress);
  if (!found) return tl::unexpected(found.error());
  const Maps maps = mapsOf(*truth, *found);
  const auto ranges = rangesOf(*truth, *found);
  std::vector<std::uint8_t> numbers;
  for (std::size_t n = 0; n < kNeckStructures; ++n) numbers.push_back(static_cast<std::uint8_t>(n + 1));
  const auto scores = scoreLabels(maps.found, maps.truth, numbers, progress);
  if (!scores) return tl::unexpected(scores.error());
  for (std::size_t n = 0; n < kNeckStructures; ++n) {
    const bool isVessel = n < kNeckVessels, isFilled = test.contrast == CtContrast::kArterial;
    SegmentationScoreRow row;
    row.variant = test.variant + ", warped";
    row.contrast = isFilled ? "arterial" : "native";
    row.noise_HU = test.noise_HU;
    row.structure = nameOf((*found)[n].structure);
    row.dice = (*scores)[n].dice;
    row.meanSurface_mm = (*scores)[n].meanSurface_mm, row.p95Surface_mm = (*scores)[n].p95Surface_mm;
    row.targetDice = !isVessel ? kTissueBar : isFilled ? kFilledBar : kNativeBar;
    if (isVessel) row.center_mm = centerError_mm(vesselNamed(*truth, row.structure), (*found)[n].line, ranges[n]);
    row.confidence = (*found)[n].confidence;
    rows.push_back(std::move(row));
  }
  return {};
}

bool isRight(const SegmentationScoreRow& row) {
  return row.dice >= kRightDice || row.center_mm.value_or(kRightCenter_mm + 1) <= kRightCenter_mm;
}

}  // namespace

Result<void> scoreAutomaticStructures(bool quick, SegmentationBench& bench, const Progress& progress) {
  const auto atlas = makeNeckAtlas(progress);
  if (!atlas) return tl::unexpected(atlas.error());
  ScoreRows rows;
  for (const TestNeck& neck : testNecks(quick))
    if (auto ok = scoreNeck(neck, *atlas, rows, progress); !ok) return ok;
  const auto isHigh = [](const SegmentationScoreRow& row) { return *row.confidence >= kHighConfidence; };
  const auto high = std::ranges::count_if(rows, isHigh);
  const auto right = std::ranges::count_if(rows, [&](const auto& row) { return isHigh(row) && isRight(row); });
  bench.notes.push_back("Automatic vessels, thyroid and muscles: " + std::to_string(high) + " of " +
                        std::to_string(rows.size()) + " structures were proposed with high confidence, of which " +
                        std::to_string(right) +
                        " are right (Dice at least 0.7, or center line within 2 mm). The lowest 18 mm of the carotid "
                        "and 8 mm of the jugular course are not proposed and not scored.");
  bench.rows.insert(bench.rows.end(), rows.begin(), rows.end());
  return {};
}

}  // namespace insonate::bench
