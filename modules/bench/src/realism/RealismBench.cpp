#include "realism/PictureParts.h"
#include "realism/SourceClassifier.h"

#include <insonate/bench/AppearanceFeatures.h>
#include <insonate/bench/RealismBench.h>
#include <insonate/ultrasound/SetupText.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

namespace insonate {
namespace {

constexpr std::size_t kMinOfASource = 4;

using bench::FeatureRow, bench::quantile;

std::vector<double> finite(const std::vector<FeatureRow>& rows, std::size_t feature, auto&& isWanted) {
  std::vector<double> values;
  for (const FeatureRow& row : rows)
    if (isWanted(row) && std::isfinite(row.values[feature])) values.push_back(row.values[feature]);
  return values;
}

/// Separation of real sources from each other by one feature.
double floorOf(const std::vector<FeatureRow>& rows, std::size_t feature) {
  std::map<std::string, std::size_t> sources;
  for (const FeatureRow& row : rows)
    if (!row.simulated) ++sources[row.source];
  std::vector<double> areas;
  for (const auto& entry : sources) {
    if (entry.second < kMinOfASource || sources.size() < 2) continue;
    const std::string& source = entry.first;
    const auto own = finite(rows, feature, [&](const FeatureRow& r) { return !r.simulated && r.source == source; });
    const auto others = finite(rows, feature, [&](const FeatureRow& r) { return !r.simulated && r.source != source; });
    if (!own.empty() && !others.empty()) areas.push_back(0.5 + std::abs(rocArea(own, others).area - 0.5));
  }
  return areas.size() < 2 ? std::numeric_limits<double>::quiet_NaN() : quantile(areas, 0.5);
}

/// Holm's correction: the smallest p times the number of tests, the next one times one test fewer, and so on; no value
/// is below the one before.
void correctForMany(std::vector<RealismComparison>& comparisons) {
  std::vector<RealismFeature*> byP;
  for (RealismComparison& comparison : comparisons)
    for (RealismFeature& feature : comparison.features) byP.push_back(&feature);
  std::ranges::sort(byP, {}, &RealismFeature::p);
  double before = 0;
  for (std::size_t n = 0; n < byP.size(); ++n)
    byP[n]->p = before = std::max(before, std::min(1.0, byP[n]->p * double(byP.size() - n)));
}

std::vector<RealismFeature> featuresOf(const std::vector<FeatureRow>& rows, const std::vector<std::string>& names) {
  std::vector<RealismFeature> features;
  for (std::size_t n = 0; n < names.size(); ++n) {
    const auto real = finite(rows, n, [](const FeatureRow& row) { return !row.simulated; });
    const auto made = finite(rows, n, [](const FeatureRow& row) { return row.simulated; });
    if (real.empty() || made.empty()) continue;
    features.push_back({.name = names[n],
                        .real = quantile(real, 0.5),
                        .realLow = quantile(real, 0.1),
                        .realHigh = quantile(real, 0.9),
                        .simulated = quantile(made, 0.5),
                        .simulatedLow = quantile(made, 0.1),
                        .simulatedHigh = quantile(made, 0.9),
                        .separation = rocArea(made, real),
                        .floor = floorOf(rows, n),
                        .p = rocP(made, real)});
  }
  std::ranges::stable_sort(features, std::greater{},
                           [](const RealismFeature& feature) { return std::abs(feature.separation.area - 0.5); });
  return features;
}

/// A feature that one kind of image never has, such as motion if the real images are stills, would give the kind away.
void removeOneSided(std::vector<FeatureRow>& rows) {
  for (std::size_t n = 0; n < rows.front().values.size(); ++n) {
    const auto isKnown = [&](bool simulated) {
      return std::ranges::any_of(
          rows, [&](const FeatureRow& row) { return row.simulated == simulated && std::isfinite(row.values[n]); });
    };
    if (isKnown(true) && isKnown(false)) continue;
    for (FeatureRow& row : rows) row.values[n] = std::numeric_limits<double>::quiet_NaN();
  }
}

RocArea classifierArea(const std::vector<FeatureRow>& rows) {
  const std::vector<double> scores = bench::leaveOneSourceOut(rows);
  std::vector<double> real, made;
  for (std::size_t n = 0; n < rows.size(); ++n)
    if (std::isfinite(scores[n])) (rows[n].simulated ? made : real).push_back(scores[n]);
  return rocArea(made, real);
}

RealismComparison compared(const RealismBench& bench, ProbeShape shape) {
  RealismComparison comparison{.probe = shape, .features = {}, .classifier = {}};
  std::vector<FeatureRow> rows;
  std::vector<std::string> names;
  for (const auto* images : {&bench.real, &bench.simulated})
    for (const SourceImage& image : *images) {
      if (image.probe != shape) continue;
      FeatureRow row{image.source, images == &bench.simulated, {}};
      names.clear();
      for (const auto& features : {appearanceFeatures(image.image), motionFeatures(image.frames)})
        for (const AppearanceFeature& feature : features)
          row.values.push_back(feature.value), names.push_back(feature.name);
      ++(row.simulated ? comparison.simulated : comparison.real);
      rows.push_back(std::move(row));
    }
  if (comparison.real == 0 || comparison.simulated == 0) return comparison;
  removeOneSided(rows);
  comparison.features = featuresOf(rows, names);
  comparison.classifier = classifierArea(rows);
  return comparison;
}

}  // namespace

bool RealismFeature::exceedsFloor() const {
  return p < 0.05 && !(0.5 + std::abs(separation.area - 0.5) <= floor);
}

Result<RealismBench> runRealismBench(std::vector<SourceImage> real, const SimulatedSet& set, const Progress& progress) {
  auto simulated = simulatedImages(set, real, progress);
  if (!simulated) return tl::unexpected(simulated.error());
  RealismBench bench{.real = std::move(real), .simulated = std::move(*simulated), .comparisons = {}, .seed = set.seed};
  for (const ProbeShape shape : {ProbeShape::Linear, ProbeShape::Curvilinear, ProbeShape::Phased})
    if (auto comparison = compared(bench, shape); comparison.real > 0 && comparison.simulated > 0)
      bench.comparisons.push_back(std::move(comparison));
  correctForMany(bench.comparisons);
  report(progress, "measuring images", 1);
  return bench;
}

namespace {

nlohmann::json number(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}

nlohmann::json toJson(const RocArea& told) {
  return {{"area", number(told.area)}, {"low", number(told.low)}, {"high", number(told.high)}};
}

}  // namespace

nlohmann::json toJson(const RealismBench& bench) {
  nlohmann::json comparisons = nlohmann::json::array();
  for (const RealismComparison& comparison : bench.comparisons) {
    nlohmann::json features = nlohmann::json::array();
    for (const RealismFeature& f : comparison.features)
      features.push_back({{"name", f.name},
                          {"real", {number(f.real), number(f.realLow), number(f.realHigh)}},
                          {"simulated", {number(f.simulated), number(f.simulatedLow), number(f.simulatedHigh)}},
                          {"roc", toJson(f.separation)},
                          {"floor", number(f.floor)},
                          {"p", number(f.p)},
                          {"beyond_floor", f.exceedsFloor()}});
    comparisons.push_back({{"probe", nameOf(comparison.probe)},
                           {"real_images", comparison.real},
                           {"simulated_images", comparison.simulated},
                           {"classifier", toJson(comparison.classifier)},
                           {"features", std::move(features)}});
  }
  return {{"real_images", bench.real.size()},
          {"simulated_images", bench.simulated.size()},
          {"seed", bench.seed},
          {"comparisons", std::move(comparisons)}};
}

nlohmann::json toJson(const BlindResult& result) {
  nlohmann::json groups = nlohmann::json::array();
  for (const BlindGroup& group : result.groups)
    groups.push_back({{"name", group.name},
                      {"real_images", group.real},
                      {"simulated_images", group.simulated},
                      {"roc", toJson(group.separation)}});
  return {{"readers", result.readers},
          {"images", result.images},
          {"sensitivity", number(result.sensitivity)},
          {"specificity", number(result.specificity)},
          {"roc", toJson(result.separation)},
          {"groups", std::move(groups)}};
}

}  // namespace insonate
