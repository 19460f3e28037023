#pragma once

#include "Site.h"

#include <insonate/curriculum/PublishedCurricula.h>

#include <unit/curriculum/StoreRig.h>

#include <string>

namespace insonate::test {

/// A class with a curriculum and attempts, and its pages without a network.
class WebSchool : public School {
 public:
  explicit WebSchool(const CurriculumStore& in, const web::WebOptions& options = {}) : School(in), site(in, options) {
    const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
    valueOf(PublishedCurricula(admin).publish(curriculum.name, curriculum.version, curriculumText(curriculum)));
    for (const Cohort& cohort : {spring, autumn})
      succeed(CohortStore(admin).setCurriculum(cohort.id, curriculum.name, curriculum.version));
    AttemptFacts facts = begunFacts();
    facts.curriculumVersion = curriculum.version;
    facts.level = curriculum.levels.front().name;
    facts.procedure = curriculum.levels.front().procedure;
    annas = keepAttempt(as(anna), facts).id;
  }

  web::Response get(const std::string& path, const std::string& secret = {}) const {
    return site.answer(request("GET", path, secret));
  }
  /// Sends a form as a browser does, from a page of the session.
  web::Response post(const std::string& path, web::Fields form, const std::string& secret = {}) const;
  /// The secret of a new session.
  std::string signIn(const std::string& name, const std::string& password = kPassword) const;

  static web::Request request(const std::string& method, const std::string& path, const std::string& secret);
  /// A request of a program on the computer of the server.
  static web::Request fromHere(const std::string& path);

  web::Site site;
  std::string annas;  ///< id of Anna's attempt
};

inline std::string headerOf(const web::Response& response, const std::string& name) {
  for (const auto& [key, value] : response.headers)
    if (key == name) return value;
  return {};
}

}  // namespace insonate::test
