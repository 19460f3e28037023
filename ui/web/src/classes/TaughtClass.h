#pragma once

#include "page/Page.h"
#include "person/PersonPage.h"

#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace insonate::web {

/// A class that the user may see, with its curriculum.
struct TaughtClass {
  Cohort cohort{};
  std::optional<Curriculum> curriculum{};
};

inline constexpr const char* kNoCurriculum = "The class has no curriculum. A curriculum defines the levels of a class.";

/// Calls work(TaughtClass) for the class with this id. If the user may not see the class, returns a page that says why.
template <class Work>
Response withClass(const Visit& visit, const std::string& id, const Work& work) {
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  const auto cohort = std::ranges::find(*cohorts, id, &Cohort::id);
  if (cohort == cohorts->end()) return refusal(visit, 404, "There is no such class, or it is not yours.");
  auto curriculum = curriculumOf(*visit.by, *cohort);
  if (!curriculum) return refusal(visit, 403, curriculum.error().message);
  return work(TaughtClass{*cohort, std::move(*curriculum)});
}

}  // namespace insonate::web
