#include <insonate/cases/Difficulty.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/cases/VesselName.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <functional>

namespace insonate {
namespace {

/// A measure beyond the limit for hard counts a little more, so that cases can still be ranked.
constexpr double kMaxPoints = 1.5;
constexpr double kModerate = 0.25, kHard = 1;

/// 0 at the easy limit, 1 at the hard limit, linear between; either may be the larger value.
double pointsOf(double value, double easy, double hard) {
  return std::clamp((value - easy) / (hard - easy), 0.0, kMaxPoints);
}

std::string text(const char* format, double value) {
  std::array<char, 64> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

void addArtery(const VeinMeasures& m, std::vector<DifficultyShare>& shares) {
  if (!m.artery_mm) return;
  // The risk of a near artery increases with the share of it behind the vein, where the needle goes.
  const double behind = std::min(1.0, pointsOf(*m.overlap_percent, 25, 75));
  const double near = std::min(1.0, pointsOf(*m.artery_mm, 6, 1));
  shares.push_back({"artery behind the vein",
                    text("%.0f %% overlap, ", *m.overlap_percent) + text("%.1f mm away", *m.artery_mm),
                    near * (0.25 + 0.75 * behind) + behind * 0.25,
                    behind > 0 ? text("%.0f %% of the artery lies behind the vein", *m.overlap_percent) +
                                     text(", %.1f mm from it", *m.artery_mm)
                               : text("the artery is only %.1f mm from the vein", *m.artery_mm)});
  shares.push_back({"artery in front of the vein", text("%.0f %% of the vein", *m.covered_percent),
                    pointsOf(*m.covered_percent, 20, 50),
                    text("the artery lies in front of %.0f %% of the vein", *m.covered_percent)});
  if (m.second_mm)
    shares.push_back({"second artery", text("%.1f mm away", *m.second_mm), 0.4 * pointsOf(*m.second_mm, 12, 6),
                      "two arteries lie beside the vein"});
}

struct HeightLimits {
  double easy_mm, hard_mm;
};

/// The veins of the arm are smaller than the central veins, and are punctured with a thinner needle.
HeightLimits heightLimitsOf(const VeinMeasures& m) {
  constexpr std::array kOfArm{KnownVessel::Basilic, KnownVessel::Brachial, KnownVessel::Cephalic};
  const auto vessel = parsedVesselName(m.target).vessel;
  if (vessel && std::ranges::find(kOfArm, *vessel) != kOfArm.end()) return {4, 2.5};
  return {10, 5};
}

std::vector<DifficultyShare> sharesOf(const VeinMeasures& m) {
  const HeightLimits limits = heightLimitsOf(m);
  std::vector<DifficultyShare> shares{
      {"height of the vein", text("%.1f mm", m.height_mm), pointsOf(m.height_mm, limits.easy_mm, limits.hard_mm),
       text("the vein is only %.1f mm high", m.height_mm)},
      {"depth of the vein", text("%.1f mm", m.depth_mm), pointsOf(m.depth_mm, 12, 20),
       text("the vein begins %.0f mm below the skin", m.depth_mm)},
      // Light compression closes a flat vein.
      {"flatness of the vein", text("%.0f %% as high as wide", 100 * m.height_mm / m.width_mm),
       0.5 * pointsOf(m.height_mm / m.width_mm, 0.5, 0.2), "the vein is flat and collapses easily under the probe"}};
  addArtery(m, shares);
  if (m.lung_mm)
    shares.push_back({"air behind the vein", text("%.0f mm away", *m.lung_mm), pointsOf(*m.lung_mm, 20, 5),
                      text("lung or airway lies %.0f mm behind it", *m.lung_mm)});
  std::ranges::stable_sort(shares, std::greater{}, &DifficultyShare::points);
  return shares;
}

std::string findingText(std::string_view grade, const std::vector<DifficultyShare>& shares) {
  constexpr double kWorthSaying = 0.15;
  std::string reasons;
  for (const DifficultyShare& share : shares)
    if (share.points >= kWorthSaying) reasons += (reasons.empty() ? "" : "; ") + share.reason;
  if (reasons.empty()) reasons = "the vein is wide, near the skin and clear of the artery";
  std::string sentence(grade);
  sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
  return sentence + ": " + reasons + ".";
}

}  // namespace

Result<DifficultyEstimate> estimateDifficulty(const CaseView& authors) {
  const auto tissues = withTissueLabels(authors.manifest.ownLabels, authors.labels);
  const CaseView patient(authors.manifest, authors.ct, tissues ? *tissues : authors.labels);
  if (patient.manifest.targets.empty())
    return fail(
        "The difficulty cannot be estimated: the case has no target. Mark a target in the vein that is to be "
        "punctured.");
  auto measures = measureVein(patient, patient.manifest.targets.front());
  if (!measures) return fail("The difficulty cannot be estimated: " + measures.error().message);
  DifficultyEstimate estimate;
  estimate.shares = sharesOf(*measures);
  for (const DifficultyShare& share : estimate.shares) estimate.points += share.points;
  estimate.grade = estimate.points >= kHard ? "hard" : estimate.points >= kModerate ? "moderate" : "easy";
  estimate.sentence = findingText(estimate.grade, estimate.shares);
  estimate.measures = std::move(*measures);
  return estimate;
}

std::string gradeOf(const CaseView& patient) {
  if (!patient.manifest.difficulty.empty()) return patient.manifest.difficulty;
  const auto estimate = estimateDifficulty(patient);
  return estimate ? std::string(estimate->grade) : std::string();
}

}  // namespace insonate
