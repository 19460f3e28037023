#include "RouteTable.h"

#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/OpeningStore.h>
#include <insonate/curriculum/Workstations.h>

#include <QUuid>
#include <utility>

namespace insonate::test {
namespace {

using Statuses = std::array<int, 6>;

constexpr Statuses kAll{200, 200, 200, 200, 200, 200}, kNone{404, 404, 404, 404, 404, 404},
    kMoved{303, 303, 303, 303, 303, 303}, kRefused{403, 403, 403, 403, 403, 403},
    kInvalid{400, 400, 400, 400, 400, 400}, kNoToken{401, 401, 401, 401, 401, 401};
constexpr Statuses kOfClass{403, 403, 404, 200, 404, 200}, kOfMember{200, 403, 404, 200, 404, 200},
    kOfAttempt{200, 404, 404, 200, 404, 200}, kOfTeachers{403, 403, 403, 200, 200, 200},
    kOfAdministrator{403, 403, 403, 403, 403, 200};

/// Pages that do not depend on a class or on a person, and requests of workstations.
std::vector<RouteLine> commonLines() {
  std::vector<RouteLine> lines{
      {.method = "GET", .route = "/style.css", .path = "/style.css", .statuses = kAll, .guest = 200},
      {.method = "GET", .route = "/icon.svg", .path = "/icon.svg", .statuses = kAll, .guest = 200},
      {.method = "GET", .route = "/live.js", .path = "/live.js", .statuses = kAll, .guest = 200},
      {.method = "GET", .route = "/video.js", .path = "/video.js", .statuses = kAll, .guest = 200},
      {.method = "GET", .route = "/health", .path = "/health", .statuses = kRefused, .guest = 403},
      {.method = "GET", .route = "/metrics", .path = "/metrics", .statuses = kRefused, .guest = 403},
      {"POST", "/api/site/cases", "/api/site/cases", {}, kNoToken, 401, 200},
      {"POST", "/api/site/case-files/*/*/*", "/api/site/case-files/none/none/0", {}, kNoToken, 401, 422},
      {"POST", "/api/site/*", "/api/site/facts", {}, kNoToken, 401, 422},
      {"POST", "/api/site/recordings/*/*/*", "/api/site/recordings/none/0/0", {}, kNoToken, 401, 422},
      {"GET", "/sign-in", "/sign-in", {}, kAll, 200},
      {"GET", "/sign-in/openid", "/sign-in/openid", {}, kNone, 404},
      {"GET", "/sign-in/openid/return", "/sign-in/openid/return", {}, kNone, 404},
      {"GET", "/", "/", {}, kMoved},
      {"GET", "/password", "/password", {}, kAll},
      {"POST", "/password", "/password", {{"old", "x"}, {"new", "one password"}, {"again", "another"}}, kInvalid},
      {"GET", "/me", "/me", {}, kAll},
      {"POST", "/me/data", "/me/data", {}, kAll},
      {"GET", "/me/events", "/me/events", {}, kAll},
      {"GET", "/me/portfolio", "/me/portfolio", {}, kAll},
      {"GET", "/me/forms/*", "/me/forms/simulator_questionnaire", {}, kAll},
      {"GET", "/me/forms/*", "/me/forms/jugular_checklist", {}, kNone},
      {"POST", "/me/forms/*", "/me/forms/simulator_questionnaire", {{"id", "{id}"}}, kMoved},
      {"GET", "/classes", "/classes", {}, kAll},
      {"POST", "/classes", "/classes", {{"name", "{name}"}}, {422, 422, 422, 422, 422, 303}},
  };
  return lines;
}

/// Answers of all questions of the checklist.
web::Fields checklist() {
  web::Fields fields{{"id", "{id}"}};
  for (const FormSection& section : valueOf(loadForm("jugular_checklist")).sections)
    for (const FormItem& item : section.items) fields.emplace("answer-" + item.name, "done");
  return fields;
}

std::vector<RouteLine> attemptLines(const WebSchool& school) {
  const std::string annas = "/attempts/" + school.annas;
  const Statuses decision{400, 404, 404, 303, 404, 303};
  return {
      {"GET", "/attempts/*", annas, {}, kOfAttempt},
      {"GET", "/attempts/*/events", annas + "/events", {}, kOfAttempt},
      {"GET", "/attempts/*/video", annas + "/video", {}, {303, 404, 404, 303, 404, 303}},
      {"POST", "/attempts/*/video", annas + "/video", {}, kNone},
      {"GET", "/attempts/*/video.webm", annas + "/video.webm", {}, kNone},
      {"POST", "/attempts/*/accept", "/attempts/{unproven}/accept", {{"reason", "watched"}}, decision},
      {"POST", "/attempts/*/void", "/attempts/{attempt}/void", {{"reason", "device"}}, decision},
      {"GET", "/attempts/*/forms/*", annas + "/forms/debrief", {}, kOfAttempt},
      {"GET", "/attempts/*/forms/*", annas + "/forms/jugular_checklist", {}, {403, 404, 404, 200, 404, 200}},
      {"POST", "/attempts/*/forms/*", annas + "/forms/jugular_checklist", checklist(), {403, 404, 404, 303, 404, 303}},
      {"POST",
       "/attempts/*/comments",
       annas + "/comments",
       {{"at", "0:01"}, {"text", "still"}},
       {403, 404, 404, 303, 404, 303}},
      {"POST",
       "/attempts/*/comments/*/remove",
       annas + "/comments/{comment}/remove",
       {},
       {403, 403, 403, 303, 403, 303}},
  };
}

std::vector<RouteLine> classLines(const WebSchool& school) {
  const std::string spring = "/classes/" + school.spring.id, anna = spring + "/people/" + school.anna.id;
  const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
  const std::string level = curriculum.levels.front().name, version = std::to_string(curriculum.version);
  const web::Fields trainee{{"name", "{name}"}, {"full-name", "New"}, {"password", "first password"}};
  const Statuses change{403, 403, 404, 303, 404, 303}, change422{403, 403, 404, 422, 404, 303};
  return {
      {"GET", "/classes/*", spring, {}, kOfClass},
      {"GET", "/classes/*/events", spring + "/events", {}, {403, 403, 403, 200, 403, 200}},
      {"GET", "/classes/*/members", spring + "/members", {}, kOfClass},
      {"POST", "/classes/*/members", spring + "/members", {{"person", "anna"}}, change422},
      {"POST", "/classes/*/members/new", spring + "/members/new", trainee, change},
      {"POST", "/classes/*/members/remove", spring + "/members/remove", {{"person", "{person}"}}, change},
      {"GET", "/classes/*/import", spring + "/import", {}, kOfClass},
      {"POST",
       "/classes/*/import",
       spring + "/import",
       {{"text", "Full name,Username\nNew,{name}\n"}},
       {422, 422, 404, 200, 404, 200}},
      {"POST",
       "/classes/*/import/confirm",
       spring + "/import/confirm",
       {{"list", "RnVsbCBuYW1lLFVzZXJuYW1lCk5ldyxuZXcKCg=="}, {"plan", "stale"}},
       {422, 422, 404, 409, 404, 409}},
      {"POST", "/classes/*/curriculum", spring + "/curriculum", {{"curriculum", version + " central_line"}}, change},
      {"POST", "/classes/*/name", spring + "/name", {{"class-name", "Spring"}}, change422},
      {"GET", "/classes/*/delete", spring + "/delete", {}, {403, 403, 404, 403, 404, 200}},
      {"GET", "/classes/*/comparison", spring + "/comparison", {}, kOfClass},
      {"GET", "/classes/*/raters", spring + "/raters", {}, kOfClass},
      {"GET", "/classes/*/raters/agreement.csv", spring + "/raters/agreement.csv", {}, kOfClass},
      {"GET", "/classes/*/levels/*", spring + "/levels/" + level, {}, {200, 200, 404, 200, 404, 200}},
      {"GET", "/classes/*/people/*", anna, {}, kOfMember},
      {"GET",
       "/classes/*/people/*",
       "/classes/" + school.autumn.id + "/people/" + school.anna.id,
       {},
       {404, 404, 403, 404, 404, 404}},
      {"GET", "/classes/*/people/*/comparison", anna + "/comparison", {}, kOfClass},
      {"GET", "/classes/*/people/*/portfolio", anna + "/portfolio", {}, kOfMember},
      {"GET", "/classes/*/people/*/events", anna + "/events", {}, kOfMember},
      {"GET", "/classes/*/export/attempts.csv", spring + "/export/attempts.csv", {}, kOfClass},
      {"GET", "/classes/*/export/grades.csv", spring + "/export/grades.csv", {}, kOfClass},
      {"GET",
       "/classes/*/export/statements.json",
       spring + "/export/statements.json?home=https%3A%2F%2Fsite.example",
       {},
       kOfClass},
      {"GET", "/classes/*/tests", spring + "/tests", {}, kOfClass},
      {"POST",
       "/classes/*/tests",
       spring + "/tests",
       {{"level", "jugular_test"}, {"whom", "class"}, {"end", "2027-01-01T12:00"}},
       {403, 403, 404, 303, 404, 409}},
      {"POST", "/classes/*/tests/close", spring + "/tests/close", {{"opening", "{opening}"}}, change},
  };
}

std::vector<RouteLine> administrationLines(const WebSchool& school) {
  const std::string anna = "/people/" + school.anna.id;
  const std::string curriculum =
      "/curricula/central_line/" + std::to_string(valueOf(loadCurriculum("central_line")).version);
  const Statuses change{403, 403, 403, 403, 403, 303}, ofOneself{422, 403, 403, 422, 403, 303},
      ofTrainee{422, 403, 403, 303, 403, 303};
  const web::Fields person{
      {"name", "{name}"}, {"full-name", "New"}, {"role", "trainee"}, {"password", "first password"}};
  return {
      {"GET", "/people", "/people", {}, kOfAdministrator},
      {"POST", "/people", "/people", person, change},
      {"GET", "/people/*", anna, {}, {200, 403, 403, 200, 403, 200}},
      {"POST",
       "/people/*",
       "/people/{person}",
       {{"name", "{sign-in}"}, {"full-name", "New"}, {"role", "trainee"}},
       ofOneself},
      {"POST", "/people/*/password", "/people/{person}/password", {{"password", "another password"}}, ofTrainee},
      {"GET", "/people/*/erase", anna + "/erase", {}, kOfAdministrator},
      {"POST", "/people/*/erase", "/people/{person}/erase", {{"name", "{sign-in}"}}, change},
      {"POST", "/people/*/data", anna + "/data", {}, {200, 403, 403, 403, 403, 200}},
      {"POST", "/people/*/state", "/people/{person}/state", {{"state", "disabled"}}, ofOneself},
      {"POST",
       "/people/*/classes",
       "/people/{person}/classes",
       {{"class", school.autumn.id}, {"as", "trainee"}},
       ofOneself},
      {"POST", "/people/*/classes/leave", "/people/{person}/classes/leave", {{"class", school.spring.id}}, ofTrainee},
      {"GET", "/curricula", "/curricula", {}, kOfTeachers},
      {"POST", "/curricula", "/curricula", {{"preset", "central_line"}}, {403, 403, 403, 303, 303, 303}},
      {"GET", "/curricula/*/*", curriculum, {}, kOfTeachers},
      {"GET", "/curricula/*/*", "/curricula/central_line/99", {}, {403, 403, 403, 404, 404, 404}},
      {"GET", "/curricula/*/*/file", curriculum + "/file", {}, kOfTeachers},
      {"GET", "/cases", "/cases", {}, kOfTeachers},
      {"GET", "/retention", "/retention", {}, kOfAdministrator},
      {"GET", "/retention", "/retention?erase=1", {}, kOfAdministrator},
      {"POST", "/retention", "/retention", {{"erase", "120"}}, change},
      {"GET", "/workstations", "/workstations", {}, kOfAdministrator},
      {"POST", "/workstations", "/workstations", {{"name", "{name}"}}, kOfAdministrator},
      {"POST", "/workstations/revoke", "/workstations/revoke", {{"name", "{workstation}"}}, change},
      {"GET", "/audit", "/audit", {}, kOfAdministrator},
  };
}

/// Requests that end the class or the sessions.
std::vector<RouteLine> lastLines(const WebSchool& school) {
  const std::string spring = "/classes/" + school.spring.id;
  return {
      {"POST", "/classes/*/archive", spring + "/archive", {{"state", "archived"}}, {403, 403, 404, 422, 404, 303}},
      {"POST", "/classes/*/delete", spring + "/delete", {{"class-name", "Spring"}}, {403, 403, 404, 403, 404, 303}},
      {"POST", "/sign-out", "/sign-out", {}, kMoved},
      {"POST", "/sign-in", "/sign-in", {{"name", "anna"}, {"password", kPassword}}, kMoved, 303},
  };
}

}  // namespace

std::vector<RouteLine> routeTable(const WebSchool& school) {
  std::vector<RouteLine> lines = commonLines();
  for (auto& more : {attemptLines(school), classLines(school), administrationLines(school), lastLines(school)})
    lines.insert(lines.end(), more.begin(), more.end());
  return lines;
}

const Person& FreshTargets::newPerson() {
  if (!person_) person_ = school_.add("fresh" + freshUuid().substr(0, 8), Role::Trainee, school_.spring.id);
  return *person_;
}

std::string FreshTargets::valueOfWord(const std::string& word) {
  if (word == "person") return newPerson().id;
  if (word == "sign-in") return newPerson().name;
  if (word == "id") return freshUuid();
  if (word == "name") return "new" + freshUuid().substr(0, 8);
  if (word == "comment") return valueOf(CommentStore(school_.as(school_.ina)).add(school_.annas, 0, "fresh"));
  if (word == "workstation") {
    const std::string name = "ward " + freshUuid().substr(0, 8);
    valueOf(Workstations(school_.admin).add(name));
    return name;
  }
  if (word == "opening")
    return valueOf(OpeningStore(school_.as(school_.ina))
                       .open({.cohort = school_.spring.id, .level = "jugular_test", .code = "venus"}))
        .id;
  AttemptFacts facts = endedFacts(begunFacts());
  const auto digits = [] { return QUuid::createUuid().toString(QUuid::Id128).toStdString(); };
  facts.recordingHash = digits() + digits();
  if (word == "unproven") facts.curriculum.clear(), facts.level.clear(), facts.proof = AttemptProof::Unproven;
  valueOf(AttemptStore(school_.as(school_.anna)).add(facts));
  return facts.id;
}

std::string FreshTargets::filledIn(std::string text) {
  for (std::size_t begin = text.find('{'); begin != std::string::npos; begin = text.find('{', begin)) {
    const std::size_t end = text.find('}', begin);
    const std::string word = text.substr(begin + 1, end - begin - 1);
    if (!values_.contains(word)) values_.emplace(word, valueOfWord(word));
    text.replace(begin, end - begin + 1, values_.at(word));
  }
  return text;
}

web::Fields FreshTargets::filledIn(web::Fields fields) {
  for (auto& [name, value] : fields) value = filledIn(value);
  return fields;
}

}  // namespace insonate::test
