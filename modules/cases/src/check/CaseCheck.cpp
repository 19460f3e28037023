#include "Checks.h"

#include <insonate/cases/TissueLabels.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>

namespace insonate {

std::string_view nameOf(FindingSeverity severity) {
  switch (severity) {
    case FindingSeverity::kError:
      return "error";
    case FindingSeverity::kWarning:
      return "warning";
    case FindingSeverity::kInfo:
      break;
  }
  return "info";
}

bool isFitForTraining(const std::vector<Finding>& findings) {
  return std::ranges::none_of(findings, [](const Finding& f) { return f.severity == FindingSeverity::kError; });
}

Result<std::vector<Finding>> checkCase(const CaseView& authors, const Progress& progress) {
  using namespace check;
  Findings findings;
  const auto cancelled = [&](double fraction) { return !report(progress, "Checking the case", fraction); };
  const auto stop = [] { return fail(std::string(kCancelled)); };

  if (cancelled(0)) return stop();
  // The labels in their form for trainees.
  const auto tissues = withTissueLabels(authors.manifest.ownLabels, authors.labels);
  const CaseView patient(authors.manifest, authors.ct, tissues ? *tissues : authors.labels);
  const LabelStatistics statistics = statisticsOf(patient);
  checkGrid(patient, statistics, findings);
  checkLabels(patient, statistics, findings);
  if (cancelled(0.3)) return stop();
  if (statistics.labeled() > 0) checkBody(patient, findings);
  if (cancelled(0.7)) return stop();
  for (const std::uint8_t vessel : {kVein, kArtery})
    if (statistics.has(vessel)) checkVessel(patient, vessel, findings);
  checkLumens(patient, statistics, findings);
  if (statistics.has(kVein) && statistics.has(kArtery)) checkWall(patient, findings);
  if (cancelled(0.8)) return stop();
  checkIslands(patient, findings);
  if (cancelled(0.9)) return stop();
  checkPlaces(patient, findings);
  checkLandmarks(patient, findings);
  checkSizes(patient, findings);
  checkThyroid(patient, statistics, findings);
  checkAnatomy(patient, findings);
  checkDifficulty(patient, findings);
  if (cancelled(1)) return stop();
  std::ranges::stable_sort(findings, {}, &Finding::severity);
  return findings;
}

}  // namespace insonate
