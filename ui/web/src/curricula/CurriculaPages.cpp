#include "curricula/CurriculaPages.h"

#include <insonate/cases/Phantom.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/site/PublishedCases.h>
#include <insonate/teaching/TeachingHere.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace insonate::web {
namespace {

/// Limits the answer to what instructors and administrators may see.
template <class Work>
Response forTeachers(const Visit& visit, const Work& work) {
  if (visit.by->person().role == Role::Trainee)
    return refusal(visit, 403, "Only instructors and administrators may see the curricula.");
  return work();
}

std::string addressOf(const std::string& name, int version) {
  return "/curricula/" + encoded(name) + "/" + std::to_string(version);
}

std::string usersOf(const std::vector<Cohort>& cohorts, const CurriculumEntry& entry) {
  std::string names;
  for (const Cohort& cohort : cohorts)
    if (cohort.curriculum == entry.name && cohort.curriculumVersion == entry.version)
      names += (names.empty() ? "" : ", ") + cohort.name;
  return names.empty() ? "none" : names;
}

Markup publishedTable(const std::vector<CurriculumEntry>& published, const std::vector<Cohort>& cohorts) {
  std::vector<std::vector<Markup>> rows;
  for (const CurriculumEntry& one : published)
    rows.push_back({link(addressOf(one.name, one.version), one.name), text(std::to_string(one.version)),
                    timeOf(one.published_us), text(one.publishedBy), text(usersOf(cohorts, one))});
  return table("Published curricula", {"Name", "Version", "Published", "Published by", "Used by your classes"}, rows);
}

Markup publishSection(const Visit& visit) {
  const Markup file = element(
      "label", {},
      text("File (JSON)") +
          element("input",
                  {{"type", "file"}, {"name", "curriculum"}, {"required", ""}, {"accept", ".json,application/json"}}));
  Choices presets;
  for (const std::string& name : curriculumPresetNames()) presets.emplace_back(name, name);
  return section(
             "Publish a curriculum",
             note("A published version cannot be changed. To change a curriculum, download its newest version, "
                  "increase the number after \"version\" in the file, and publish the file. Levels may name built-in "
                  "cases and the published cases of this server.") +
                 element("p", {}, link("/cases", "Cases of this server")) +
                 fileForm(visit, "/curricula", file, "Publish the file")) +
         section("Publish a built-in curriculum",
                 postForm(visit, "/curricula", choiceField("Built-in curriculum", "preset", presets, {}), "Publish"));
}

Response curriculaPage(const Visit& visit, const std::string& trouble) {
  const auto published = PublishedCurricula(*visit.by).list();
  if (!published) return refusal(visit, 403, published.error().message);
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  Markup content = trouble.empty() ? Markup() : troubleLine(trouble);
  content += note(
      "A curriculum is a list of levels with their cases, standards and prerequisites. A class learns one "
      "version of a curriculum, which is chosen under Members and settings of the class.");
  content += published->empty() ? paragraph("No curriculum is published yet.") : publishedTable(*published, *cohorts);
  return page(visit, "Curricula", content + publishSection(visit), trouble.empty() ? 200 : 422);
}

/// Reads the sent file, or the chosen built-in curriculum.
Result<Curriculum> sentCurriculum(const Visit& visit) {
  const std::string& preset = valueOf(visit.request.form, "preset");
  // loadCurriculum() reads files, too, and a browser must not name files of the server.
  if (const auto all = curriculumPresetNames(); std::ranges::find(all, preset) != all.end())
    return loadCurriculum(preset);
  const std::string& file = valueOf(visit.request.files, "curriculum");
  if (file.empty()) return fail("No curriculum was chosen. Choose a file, or a built-in curriculum.");
  return parseCurriculum(file);
}

Result<CurriculumEntry> publish(const Visit& visit) {
  const auto curriculum = sentCurriculum(visit);
  if (!curriculum) return tl::unexpected(curriculum.error());
  const auto titles = visit.cases.offeredTitles();
  if (!titles) return tl::unexpected(titles.error());
  const auto names = teachingNames(*titles);
  if (!names) return tl::unexpected(names.error());
  if (auto known = checkNames(*curriculum, *names); !known) return tl::unexpected(known.error());
  return PublishedCurricula(*visit.by).publish(curriculum->name, curriculum->version, curriculumText(*curriculum));
}

std::string caseTitle(const std::string& nameOrTitle) {
  const PhantomVariant* builtIn = phantomVariant(nameOrTitle);
  return builtIn ? std::string(builtIn->title) : nameOrTitle;
}

std::string helpWord(Assistance assistance) {
  switch (assistance) {
    case Assistance::Guided:
      return "guided";
    case Assistance::Hints:
      return "hints only";
    case Assistance::Test:
      break;
  }
  return "test";
}

std::string titlesOf(const Curriculum& curriculum, const std::vector<std::string>& levels) {
  std::string titles;
  for (const std::string& name : levels) {
    const Level* level = curriculum.level(name);
    titles += (titles.empty() ? "" : ", ") + (level ? level->title : name);
  }
  return titles.empty() ? "none" : titles;
}

Markup levelTable(const Curriculum& curriculum) {
  std::vector<std::vector<Markup>> rows;
  for (const Level& level : curriculum.levels) {
    const auto procedure = builtInProcedure(level.procedure);
    rows.push_back(
        {text(level.title), text(caseTitle(level.caseName)), text(procedure ? procedure->title : level.procedure),
         text(helpWord(level.assistance)), text(std::to_string(level.pass.standards.size())),
         text(std::to_string(level.mastery.consecutivePasses)), text(titlesOf(curriculum, level.prerequisites))});
  }
  return table("Levels",
               {"Level", "Case", "Procedure", "Assistance", "Standards", "Consecutive passes", "Prerequisite levels"},
               rows);
}

/// Calls work(text) for the JSON text of a published version.
template <class Work>
Response withText(const Visit& visit, const Parts& parts, const Work& work) {
  return forTeachers(visit, [&] {
    int version = 0;
    const auto [end, error] = std::from_chars(parts[1].data(), parts[1].data() + parts[1].size(), version);
    const bool isNumber = error == std::errc() && end == parts[1].data() + parts[1].size();
    const auto published =
        isNumber ? PublishedCurricula(*visit.by).text(parts[0], version) : fail("There is no such curriculum.");
    return published ? work(*published) : refusal(visit, 404, published.error().message);
  });
}

}  // namespace

Response showCurricula(const Visit& visit, const Parts& /*parts*/) {
  return forTeachers(visit, [&] { return curriculaPage(visit, {}); });
}

Response publishCurriculum(const Visit& visit, const Parts& /*parts*/) {
  return forTeachers(visit, [&] {
    const auto entry = publish(visit);
    return entry ? redirect(addressOf(entry->name, entry->version)) : curriculaPage(visit, entry.error().message);
  });
}

Response showCurriculum(const Visit& visit, const Parts& parts) {
  return withText(visit, parts, [&](const std::string& published) {
    const auto curriculum = parseCurriculum(published);
    if (!curriculum) return refusal(visit, 422, curriculum.error().message);
    return page(
        visit, curriculum->title + ", version " + std::to_string(curriculum->version),
        paragraph(curriculum->about) + levelTable(*curriculum) +
            element("p", {}, link(addressOf(curriculum->name, curriculum->version) + "/file", "Download (JSON)")) +
            element("p", {}, link("/curricula", "All curricula")));
  });
}

Response downloadCurriculum(const Visit& visit, const Parts& parts) {
  return withText(visit, parts, [&](const std::string& published) {
    return download(parts[0] + "-" + parts[1] + ".json", "application/json", published);
  });
}

}  // namespace insonate::web
