#include "cases/CasesPage.h"

#include "person/PersonPage.h"

#include <insonate/cases/Phantom.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/site/PublishedCases.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <set>

namespace insonate::web {
namespace {

/// Titles of the levels by the name of their case, in the curricula of the classes that the user may see.
using LevelsByCase = std::map<std::string, std::set<std::string>>;

Result<LevelsByCase> levelsByCase(const SignedIn& by) {
  const auto cohorts = CohortStore(by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  LevelsByCase levels;
  for (const Cohort& cohort : *cohorts) {
    if (cohort.archived) continue;
    const auto curriculum = curriculumOf(by, cohort);
    if (!curriculum) return tl::unexpected(curriculum.error());
    if (!*curriculum) continue;
    for (const Level& level : (*curriculum)->levels)
      levels[level.caseName].insert((*curriculum)->title + ": " + level.title);
  }
  return levels;
}

std::string joined(const std::set<std::string>& texts) {
  std::string all;
  for (const std::string& one : texts) all += (all.empty() ? "" : "; ") + one;
  return all;
}

std::string sizeText(std::int64_t bytes) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f MB", static_cast<double>(bytes) * 1e-6);
  return text;
}

Markup casesTable(const std::vector<PublishedCase>& cases, const LevelsByCase& levels) {
  std::vector<std::vector<Markup>> rows;
  for (const PublishedCase& one : cases) {
    const auto used = levels.find(one.title);
    const std::string use = !one.whyNotOffered.empty() ? "not offered: " + one.whyNotOffered
                            : used == levels.end()     ? "none"
                                                       : joined(used->second);
    rows.push_back({text(one.title), text(std::to_string(one.version.number)), text(one.version.date),
                    text(sizeText(one.size_bytes())), text(use)});
  }
  return table("Published cases on this server", {"Title", "Version", "Saved", "Size", "Levels of your classes"}, rows);
}

Markup missingTable(const std::vector<PublishedCase>& cases, const LevelsByCase& levels) {
  const auto isOffered = [&](const std::string& title) {
    return std::ranges::any_of(
        cases, [&](const PublishedCase& one) { return one.title == title && one.whyNotOffered.empty(); });
  };
  std::vector<std::vector<Markup>> rows;
  for (const auto& [name, titles] : levels)
    if (!phantomVariant(name) && !isOffered(name)) rows.push_back({text(name), text(joined(titles))});
  if (rows.empty()) return {};
  return section(
      "Missing cases",
      note("Trainees can practice these levels only on workstations where the case was opened before. Publish "
           "the case, and copy its folder into the server's folder for cases.") +
          table("Cases that levels need and this server does not offer", {"Case", "Levels"}, rows));
}

}  // namespace

Response showCases(const Visit& visit, const Parts& /*parts*/) {
  if (visit.by->person().role == Role::Trainee)
    return refusal(visit, 403, "Only instructors and administrators may see the cases of the server.");
  const auto levels = levelsByCase(*visit.by);
  if (!levels) return refusal(visit, 403, levels.error().message);
  const auto cases = visit.cases.list();
  if (!cases) return refusal(visit, 503, cases.error().message);
  Markup content = note(
      "Workstations download the published version of each case that the levels of their classes need. Built-in "
      "cases are not listed, since each workstation has them. Cases of which no version was published are not "
      "offered.");
  if (visit.options.cases.empty())
    content +=
        paragraph("This server has no folder for cases. Its administrator sets the folder with the option 'cases'.");
  else
    content += cases->empty() ? paragraph("The server's folder for cases has no published case.")
                              : casesTable(*cases, *levels);
  return page(visit, "Cases",
              content + missingTable(*cases, *levels) + element("p", {}, link("/curricula", "All curricula")));
}

}  // namespace insonate::web
