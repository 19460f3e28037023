#include "WebRig.h"
#include "page/Page.h"

#include <insonate/curriculum/AuditLog.h>

#include <algorithm>
#include <array>
#include <thread>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebListImport : public OnBoth {
 protected:
  /// Sends a list as a file, as a browser does.
  static web::Response check(const WebSchool& school, const std::string& secret, const std::string& list) {
    web::Request made = WebSchool::request("POST", addressIn(school), secret);
    made.headers["sec-fetch-site"] = "same-origin";
    made.form = {{"code", web::formCode(secret)}, {"text", ""}};
    made.files = {{"list", list}};
    return school.site.answer(made);
  }
  static std::string addressIn(const WebSchool& school) { return "/classes/" + school.spring.id + "/import"; }
  /// The value of a hidden field of a page.
  static std::string hidden(const web::Response& page, const std::string& name) {
    const std::string begin = "name=\"" + name + "\" value=\"";
    const std::size_t at = page.body.find(begin);
    if (at == std::string::npos) return {};
    const std::size_t from = at + begin.size();
    return page.body.substr(from, page.body.find('"', from) - from);
  }
  static web::Response confirm(const WebSchool& school, const std::string& secret, const web::Response& plan) {
    return school.post(
        addressIn(school) + "/confirm",
        {{"list", hidden(plan, "list")}, {"plan", hidden(plan, "plan")}, {"import", hidden(plan, "import")}}, secret);
  }
  static std::size_t people(const WebSchool& school) { return valueOf(PeopleStore(school.admin).all()).size(); }
};
INSONATE_ON_BOTH(WebListImport);

const std::string kList =
    "Vorname;Nachname;Anmeldename\nDora;J\xE4ger;dora\nAnna;Dr;anna\n;;\nBad;Name;two words\nEmil;Falk;emil\n";

TEST_P(WebListImport, FirstSaysWhatItWouldDoThenDoesIt) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina");
  const web::Response plan = check(school, ina, kList);
  EXPECT_EQ(plan.status, 200);
  EXPECT_THAT(
      plan.body,
      AllOf(HasSubstr("New accounts: 2. People with an account who join the class: 0. Already in the class: 1."),
            HasSubstr("Dora J\xC3\xA4ger"), HasSubstr("left out: "), HasSubstr("Import</button>")));
  EXPECT_EQ(people(school), 6U) << "nothing was done";

  const web::Response done = confirm(school, ina, plan);
  EXPECT_EQ(done.status, 200);
  EXPECT_THAT(done.body,
              AllOf(HasSubstr("First passwords"), HasSubstr("dora"), HasSubstr("emil"), HasSubstr("Left out")));
  EXPECT_EQ(people(school), 8U);
  const std::string code = "<code class=\"token\">";
  const std::size_t at = done.body.find(code, done.body.find("J\xC3\xA4ger")) + code.size();
  const std::string password = done.body.substr(at, 14);
  EXPECT_TRUE(valueOf(rig->open().signIn("dora", password)).mustChangePassword());
  const auto log = valueOf(AuditLog(school.admin).page(20));
  EXPECT_TRUE(std::ranges::any_of(
      log, [](const AuditEntry& one) { return one.detail.find("class list, 2 new, 0 known") != std::string::npos; }));

  rig->pass(11 * 60 * kSecond_us);
  const web::Response again = confirm(school, ina, plan);
  EXPECT_EQ(again.status, 409);
  EXPECT_THAT(again.body, AllOf(HasSubstr("Nothing was imported"), Not(HasSubstr("First passwords")),
                                HasSubstr("no people to add to the class")));
  EXPECT_EQ(people(school), 8U);
}

TEST_P(WebListImport, ASecondClickShowsTheSamePasswords) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina");
  const web::Response plan = check(school, ina, kList), done = confirm(school, ina, plan);
  ASSERT_THAT(done.body, HasSubstr("First passwords"));
  rig->pass(9 * 60 * kSecond_us);
  EXPECT_EQ(confirm(school, ina, plan).body, done.body);
  EXPECT_EQ(people(school), 8U);
  const web::Response elsewhere = confirm(school, school.signIn("ina"), plan);
  EXPECT_EQ(elsewhere.status, 409) << "in another session";
  EXPECT_THAT(elsewhere.body, Not(HasSubstr("First passwords")));
  rig->pass(2 * 60 * kSecond_us);
  EXPECT_EQ(confirm(school, ina, plan).status, 409) << "after ten minutes";
}

TEST_P(WebListImport, AnotherPageOfTheSameCheckIsNoSecondClick) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina"), list = "Full name,Username\nDora D,dora\n";
  const web::Response plan = check(school, ina, list), same = check(school, ina, list);
  EXPECT_EQ(confirm(school, ina, plan).status, 200);
  EXPECT_EQ(confirm(school, ina, same).status, 409);
}

TEST_P(WebListImport, AnotherServerNamesThePeopleWhoWereImported) {
  const WebSchool school(rig->open());
  const web::Site other(rig->open(), {});
  const std::string ina = school.signIn("ina");
  const web::Response plan = check(school, ina, kList);
  web::Request repeated = WebSchool::request("POST", addressIn(school) + "/confirm", ina);
  repeated.headers["sec-fetch-site"] = "same-origin";
  repeated.form = {{"list", hidden(plan, "list")},
                   {"plan", hidden(plan, "plan")},
                   {"import", hidden(plan, "import")},
                   {"code", web::formCode(ina)}};
  std::array<web::Response, 2> answers;
  std::thread second([&] { answers[1] = other.answer(repeated); });
  answers[0] = confirm(school, ina, plan);
  second.join();
  if (answers[0].status != 200) std::swap(answers[0], answers[1]);
  EXPECT_EQ(answers[0].status, 200) << "at the same time, one of them imports the list";
  EXPECT_EQ(answers[1].status, 409);
  EXPECT_EQ(people(school), 8U);
  const auto members = valueOf(CohortStore(school.admin).members(school.spring.id));
  const auto dora = std::ranges::find(members, "dora", [](const Member& one) { return one.person.name; });
  ASSERT_NE(dora, members.end());
  EXPECT_THAT(answers[1].body,
              AllOf(HasSubstr("was imported already"), HasSubstr("Set a new password on the page of each account"),
                    HasSubstr("/people/" + dora->person.id), Not(HasSubstr("First passwords"))));
  EXPECT_EQ(school.get("/people/" + dora->person.id, ina).status, 200);
}

TEST_P(WebListImport, APastedListIsReadToo) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina");
  const web::Response plan =
      school.post(addressIn(school), {{"text", "Nom complet\tIdentifiant\nZo\xC3\xA9 Dupont\tzoe\n"}}, ina);
  EXPECT_THAT(plan.body, AllOf(HasSubstr("Zo\xC3\xA9 Dupont"), HasSubstr("New accounts: 1.")));
  EXPECT_EQ(confirm(school, ina, plan).status, 200);
  EXPECT_TRUE(std::ranges::any_of(valueOf(CohortStore(school.admin).members(school.spring.id)), [](const Member& one) {
    return one.person.name == "zoe" && one.person.fullName == "Zo\xC3\xA9 Dupont";
  }));
}

TEST_P(WebListImport, AListThatCannotBeUsedSaysWhy) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina");
  const auto refused = [&](const std::string& list) {
    const web::Response page = check(school, ina, list);
    EXPECT_EQ(page.status, 422);
    EXPECT_THAT(page.body, HasSubstr("role=\"alert\""));
    return page.body;
  };
  EXPECT_THAT(refused(""), HasSubstr("No list was chosen"));
  EXPECT_THAT(refused("Full name,Username\n"), HasSubstr("no trainees"));
  EXPECT_THAT(refused("1,2,3\n4,5,6\n"), HasSubstr("its first line needs"));
  EXPECT_THAT(refused("Full name,Username\n" + std::string(129 << 10, 'a')), HasSubstr("larger than 128 KB"));
  std::string many = "Full name,Username\n";
  for (int i = 0; i < 301; ++i) many += "P " + std::to_string(i) + ",p" + std::to_string(i) + "\n";
  EXPECT_THAT(refused(many), HasSubstr("more than 300 new people"));
  const web::Response bad = check(school, ina, "Full name,Username\nBad,two words\n");
  EXPECT_THAT(bad.body, AllOf(HasSubstr("Every line has an error"), Not(HasSubstr("Import</button>"))));
  for (const auto& [list, plan] : std::vector<std::pair<std::string, std::string>>{{"", ""}, {"???", "x"}})
    EXPECT_EQ(school.post(addressIn(school) + "/confirm", {{"list", list}, {"plan", plan}}, ina).status, 422);
  EXPECT_EQ(people(school), 6U);
}

TEST_P(WebListImport, WhatHasChangedSinceTheCheckIsShownAgain) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina");
  const web::Response plan = check(school, ina, "Full name,Username\nDora D,dora\nEmil E,emil\n");
  valueOf(PeopleStore(school.admin).add({"dora", "Another Dora"}, kPassword));
  const web::Response changed = confirm(school, ina, plan);
  EXPECT_EQ(changed.status, 409);
  EXPECT_THAT(changed.body, AllOf(HasSubstr("people or classes have changed"), HasSubstr("left out: ")));
  EXPECT_EQ(people(school), 7U) << "neither of the two";
  EXPECT_EQ(confirm(school, ina, changed).status, 200);
  EXPECT_EQ(people(school), 8U);
}

TEST_P(WebListImport, OnlyWhoMayAddPeopleImportsThem) {
  const WebSchool school(rig->open());
  const std::string list = "Full name,Username\nDora D,dora\nCarl C,carl\n";
  const web::Response plan = check(school, school.signIn("admin"), list);
  EXPECT_THAT(plan.body, HasSubstr("New accounts: 1. People with an account who join the class: 1."));
  for (const auto& [who, status] :
       std::map<std::string, int>{{"anna", 422}, {"ben", 422}, {"carl", 404}, {"otto", 404}}) {
    const std::string secret = school.signIn(who);
    EXPECT_EQ(check(school, secret, list).status, status) << who;
    EXPECT_EQ(confirm(school, secret, plan).status, status) << who;
  }
  web::Request forged = WebSchool::request("POST", addressIn(school), school.signIn("ina"));
  forged.files = {{"list", list}};
  EXPECT_EQ(school.site.answer(forged).status, 403) << "without the code of the form";
  EXPECT_EQ(confirm(school, school.signIn("ina"), plan).status, 409) << "carl is for administrators to add";
  EXPECT_EQ(people(school), 6U);
}

TEST_P(WebListImport, HostileTextStaysText) {
  const WebSchool school(rig->open());
  const std::string hostile = "<script>alert(1)</script>", ina = school.signIn("ina");
  const web::Response plan =
      check(school, ina, "Full name,Username\n\"" + hostile + "\",dora\n" + hostile + "," + hostile + "\n");
  EXPECT_THAT(plan.body, AllOf(HasSubstr("&lt;script&gt;"), Not(HasSubstr("<script"))));
  EXPECT_THAT(confirm(school, ina, plan).body, AllOf(HasSubstr("&lt;script&gt;"), Not(HasSubstr("<script"))));
  EXPECT_THAT(school.post(addressIn(school), {{"text", "</textarea>" + hostile}}, ina).body, Not(HasSubstr("<script")));
}

}  // namespace
}  // namespace insonate::test
