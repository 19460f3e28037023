#include "Checks.h"

#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <optional>

namespace insonate::check {
namespace {

constexpr int kAirHu = -900;

struct HuRange {
  int low, high;
};

/// The ranges include noise, partial volume, contrast agent and metal; only a wrong label has most of its voxels
/// outside.
std::optional<HuRange> plausibleHu(int label) {
  switch (label) {
    case kSkin:
      return HuRange{-950, 400};  // a thin shell is mostly partial volume
    case kFat:
      return HuRange{-250, 60};
    case kAirway:
      return HuRange{-1024, -150};
    case kBone:
      return HuRange{-50, 3071};  // fatty marrow to enamel
    case kCartilage:
      return HuRange{-20, 1200};  // laryngeal cartilage ossifies
    case kOesophagus:
      return HuRange{-1024, 400};
    case kVein:  // checkLumens() checks both
    case kArtery:
    case kBackground:
      return std::nullopt;
    case kSoftTissue:
      return HuRange{-900, 900};  // all others, including thin linings of air
    default:
      return HuRange{-200, 500};
  }
}

std::size_t countIn(const std::vector<std::uint32_t>& histogram, HuRange range) {
  const auto begin = histogram.begin() + (range.low - LabelStatistics::kLowestHu);
  return std::accumulate(begin, begin + (range.high - range.low + 1), std::size_t{0});
}

int medianHu(const std::vector<std::uint32_t>& histogram, std::size_t total) {
  std::size_t below = 0;
  for (std::size_t bin = 0; bin < histogram.size(); ++bin)
    if ((below += histogram[bin]) * 2 >= total) return static_cast<int>(bin) + LabelStatistics::kLowestHu;
  return LabelStatistics::kHighestHu;
}

std::string wholePercent(double share) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.0f %%", share * 100);
  return text.data();
}

void checkPresence(const LabelStatistics& s, Findings& findings) {
  if (s.labeled() == 0) {
    findings.push_back({FindingSeverity::kError, "labels_empty",
                        "Nothing is labeled yet. Run the first step of the guide in Prepare, import with "
                        "--auto-label, or label the CT in another program, e.g. 3D Slicer."});
    return;
  }
  const auto require = [&](int label, FindingSeverity severity, const char* code, const std::string& why) {
    if (!s.has(label))
      findings.push_back({severity,
                          code,
                          "No voxel is labeled " + labelName(label) + " (" + std::to_string(label) + "): " + why,
                          {},
                          static_cast<std::uint8_t>(label)});
  };
  require(kVein, FindingSeverity::kError, "no_vein",
          "there is no vessel to puncture. Label the internal jugular vein.");
  require(kArtery, FindingSeverity::kError, "no_artery",
          "an artery cannot be distinguished from the vein, and the puncture of an artery is not detected. Label the "
          "carotid artery.");
  require(kSkin, FindingSeverity::kError, "no_skin",
          "the probe and the needle meet nothing at the surface. Label the skin.");
  require(kBone, FindingSeverity::kWarning, "no_bone", "the image will have no shadows of bone. Label the bone.");
}

void checkHu(const LabelStatistics& s, int label, Findings& findings) {
  const auto range = plausibleHu(label);
  if (!range || !s.has(label)) return;
  const double total = static_cast<double>(s.voxels[label]);
  const double outside = 1 - static_cast<double>(countIn(s.histogram[label], *range)) / total;
  if (outside <= 0.25) return;
  findings.push_back({outside > 0.75 ? FindingSeverity::kError : FindingSeverity::kWarning,
                      "hu_implausible",
                      wholePercent(outside) + " of the voxels labeled " + labelName(label) +
                          " have Hounsfield units that " + labelName(label) + " cannot have (median " +
                          std::to_string(medianHu(s.histogram[label], s.voxels[label])) + ", expected " +
                          std::to_string(range->low) + " to " + std::to_string(range->high) +
                          "). The label or its location is wrong.",
                      {},
                      static_cast<std::uint8_t>(label)});
}

}  // namespace

std::size_t LabelStatistics::labeled() const {
  return std::accumulate(voxels.begin() + 1, voxels.end(), std::size_t{0});
}

LabelStatistics statisticsOf(const CaseView& patient) {
  LabelStatistics s;
  const auto& hu = patient.ct.voxels;
  const auto [lowest, highest] = std::ranges::minmax_element(hu);
  s.minHu = *lowest;
  s.maxHu = *highest;
  for (std::size_t v = 0; v < hu.size(); ++v) {
    const std::uint8_t label = patient.labels.voxels[v];
    auto& histogram = s.histogram[label];
    if (histogram.empty()) histogram.resize(LabelStatistics::kHighestHu - LabelStatistics::kLowestHu + 1);
    const int bin = std::clamp<int>(hu[v], LabelStatistics::kLowestHu, LabelStatistics::kHighestHu);
    ++histogram[bin - LabelStatistics::kLowestHu];
    ++s.voxels[label];
    s.inAir[label] += hu[v] < kAirHu;
  }
  return s;
}

std::string labelName(int label) {
  return label < kLabelCount ? std::string(labelTable()[label].name) : "label " + std::to_string(label);
}

double voxelVolume_mm3(const VolumeGeometry& g) {
  return g.spacing_mm.x * g.spacing_mm.y * g.spacing_mm.z;
}

void checkLabels(const CaseView& patient, const LabelStatistics& s, Findings& findings) {
  checkPresence(s, findings);
  const auto firstOf = [&](int label) {
    const auto at = std::ranges::find(patient.labels.voxels, static_cast<std::uint8_t>(label));
    return placeOf(patient.labels.geometry, static_cast<std::size_t>(at - patient.labels.voxels.begin()));
  };
  std::size_t inAir = 0;
  for (int label = 1; label < 256; ++label) {
    if (label >= kLabelCount && s.has(label))
      findings.push_back({FindingSeverity::kError, "unknown_label",
                          std::to_string(s.voxels[label]) + " voxels have the label " + std::to_string(label) +
                              ", which is unknown here (0 to " + std::to_string(kLabelCount - 1) +
                              " are known). Give it a tissue in the table of structures, renumber or erase it.",
                          firstOf(label), static_cast<std::uint8_t>(label)});
    checkHu(s, label, findings);
    if (label != kAirway && label != kSkin && label != kOesophagus) inAir += s.inAir[label];
  }
  const double inAir_ml = static_cast<double>(inAir) * voxelVolume_mm3(patient.ct.geometry) / 1000;
  if (inAir_ml > 1 && static_cast<double>(inAir) > 0.001 * static_cast<double>(s.labeled()))
    findings.push_back({FindingSeverity::kWarning, "labels_in_air",
                        std::to_string(static_cast<long>(inAir_ml)) +
                            " ml of tissue labels lie in air (below -900 HU), outside the body or in its airways."});
}

}  // namespace insonate::check
