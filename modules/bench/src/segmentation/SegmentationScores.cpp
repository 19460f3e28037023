#include "SegmentationParts.h"
#include "VesselScore.h"

#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/Score.h>
#include <insonate/tissue/Labels.h>

namespace insonate::bench {
namespace {

constexpr std::size_t kVesselsEach = 2;  // the largest vessels of each kind
constexpr double kShortest_mm = 40;
constexpr double kAutomaticBar = 0.95, kVesselBar = 0.90;

std::optional<double> barOf(std::uint8_t label) {
  const bool aimedAt = label == kBone || label == kAirway || label == kSkin;
  return aimedAt ? std::optional(kAutomaticBar) : std::nullopt;
}

Result<void> scoreAutomatic(const CtVolume& ct, const LabelMap& truth, const SegmentationScoreRow& about,
                            ScoreRows& rows, const Progress& progress) {
  const auto labels = autoLabel(ct, progress);
  if (!labels) return tl::unexpected(labels.error());
  const auto scores = scoreLabels(*labels, truth, {kBone, kAirway, kSkin, kFat, kMuscle}, progress);
  if (!scores) return tl::unexpected(scores.error());
  for (const LabelScore& score : *scores) {
    SegmentationScoreRow row = about;
    row.structure = labelName(score.label);
    row.dice = score.dice, row.meanSurface_mm = score.meanSurface_mm, row.p95Surface_mm = score.p95Surface_mm;
    row.targetDice = barOf(score.label);
    rows.push_back(row);
  }
  return {};
}

/// Kind of a vessel, and its rank by decreasing volume.
struct RankedVessel {
  std::string name;
  TrueVessel vessel;
};

Result<std::vector<RankedVessel>> rankedVessels(const LabelMap& truth, const Progress& progress) {
  std::vector<RankedVessel> named;
  for (const Label label : {kVein, kArtery}) {
    auto vessels = trueVessels(truth, label, kVesselsEach, kShortest_mm, progress);
    if (!vessels) return tl::unexpected(vessels.error());
    for (std::size_t n = 0; n < vessels->size(); ++n)
      named.push_back({labelName(label) + " " + std::to_string(n + 1), std::move((*vessels)[n])});
  }
  return named;
}

Result<void> scoreVessels(const CtVolume& ct, const std::vector<RankedVessel>& vessels,
                          const SegmentationScoreRow& about, ScoreRows& rows, const Progress& progress) {
  for (const auto& [name, vessel] : vessels)
    for (const int clicks : {2, 4}) {
      SegmentationScoreRow row = about;
      row.structure = name;
      if (clicks == 4) row.targetDice = kVesselBar;
      auto scored = scoreClicks(ct, vessel, clicks, {}, row, progress);
      if (!scored) return tl::unexpected(scored.error());
      rows.push_back(std::move(*scored));
    }
  return {};
}

}  // namespace

Result<ScoreRows> scoreTruth(const PatientCase& truth, const std::string& variant, std::span<const double> noises_HU,
                             double resolution_FWHM_mm, const Progress& progress) {
  const auto vessels = rankedVessels(truth.labels, progress);
  if (!vessels) return tl::unexpected(vessels.error());
  ScoreRows rows;
  for (const CtContrast contrast : {CtContrast::kNative, CtContrast::kArterial})
    for (const double noise_HU : noises_HU) {
      const CtSynthesisOptions how{
          .seed = 1, .contrast = contrast, .noise_HU = noise_HU, .resolution_FWHM_mm = resolution_FWHM_mm};
      const auto ct = synthesizeCt(truth.labels, how, progress);
      if (!ct) return tl::unexpected(ct.error());
      SegmentationScoreRow about;
      about.variant = variant;
      about.contrast = contrast == CtContrast::kNative ? "native" : "arterial";
      about.noise_HU = noise_HU;
      if (auto ok = scoreAutomatic(*ct, truth.labels, about, rows, progress); !ok) return tl::unexpected(ok.error());
      if (contrast == CtContrast::kNative) continue;
      if (auto ok = scoreVessels(*ct, *vessels, about, rows, progress); !ok) return tl::unexpected(ok.error());
    }
  return rows;
}

}  // namespace insonate::bench
