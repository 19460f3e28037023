#include "classes/ClassPages.h"
#include "classes/TaughtClass.h"

#include <insonate/teaching/ClassExports.h>

namespace insonate::web {
Response exportClassAttempts(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    const auto table = exportAttempts(*visit.by, taught.cohort, taught.curriculum ? &*taught.curriculum : nullptr);
    return table ? download("attempts.csv", "text/csv; charset=utf-8", table->csv)
                 : refusal(visit, 403, table.error().message);
  });
}

Response exportClassGrades(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
    if (!taught.curriculum) return refusal(visit, 404, kNoCurriculum);
    const GradeKey key = valueOf(visit.request.query, "by") == "name" ? GradeKey::Name : GradeKey::Email;
    const auto grades = exportGrades(*visit.by, taught.cohort, *taught.curriculum, "Insonate", key);
    return grades ? download("grades.csv", "text/csv; charset=utf-8", grades->book.csv)
                  : refusal(visit, 403, grades.error().message);
  });
}

Response exportClassStatements(const Visit& visit, const Parts& parts) {
  return withClass(visit, parts[0], [&](const TaughtClass& taught) {
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
