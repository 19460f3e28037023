#include "classes/ClassPages.h"
#include "person/PersonPage.h"

#include <insonate/teaching/ClassExports.h>

#include <algorithm>

namespace insonate::web {
namespace {

/// A class that the user may see, with its curriculum.
struct Taught {
  Cohort cohort{};
  std::optional<Curriculum> curriculum{};
};

/// Calls work(taught) for the class of this id, or returns a page that says why not.
template <class Work>
Response withClass(const Visit& visit, const std::string& id, const Work& work) {
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  const auto cohort = std::ranges::find(*cohorts, id, &Cohort::id);
  if (cohort == cohorts->end()) return refusal(visit, 404, "There is no such class, or it is not yours.");
  auto curriculum = curriculumOf(*visit.by, *cohort);
  if (!curriculum) return refusal(visit, 403, curriculum.error().message);
  return work(Taught{*cohort, std::move(*curriculum)});
}

constexpr const char* kNoCurriculum = "The class has no curriculum, by which its levels would be judged.";

}  // namespace

Response exportClassAttempts(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const Taught& taught) {
    const auto table = exportAttempts(*visit.by, taught.cohort, taught.curriculum ? &*taught.curriculum : nullptr);
    return table ? download("attempts.csv", "text/csv; charset=utf-8", table->csv)
                 : refusal(visit, 403, table.error().message);
  });
}

Response exportClassGrades(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const Taught& taught) {
    if (!taught.curriculum) return refusal(visit, 404, kNoCurriculum);
    const GradeKey key = valueOf(visit.request.query, "by") == "name" ? GradeKey::Name : GradeKey::Email;
    const auto grades = exportGrades(*visit.by, taught.cohort, *taught.curriculum, "Insonate", key);
    return grades ? download("grades.csv", "text/csv; charset=utf-8", grades->book.csv)
                  : refusal(visit, 403, grades.error().message);
  });
}

Response exportClassStatements(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const Taught& taught) {
    if (!taught.curriculum) return refusal(visit, 404, kNoCurriculum);
    const XapiSite site{.homePage = valueOf(visit.request.query, "home")};
    if (const auto tried = xapiStatements(site, *taught.curriculum, {}, {}); !tried)
      return refusal(visit, 400, tried.error().message);
    const auto all = exportStatements(*visit.by, taught.cohort, *taught.curriculum, site);
    return all ? download("statements.json", "application/json", xapiText(all->statements))
               : refusal(visit, 403, all.error().message);
  });
}

}  // namespace insonate::web
