#include "WebRig.h"

#include <insonate/curriculum/AuditLog.h>

#include <algorithm>
#include <functional>
#include <regex>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// The number of the last change grows with each look at the class.
std::string withoutNumber(const std::string& body) {
  return std::regex_replace(body, std::regex("since=[0-9]+"), "since=");
}

class WebClassContents : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    school.emplace(rig->open());
    ina = school->signIn("ina"), admin = school->signIn("admin");
    address = "/classes/" + school->spring.id;
  }
  /// The page of a server that has stored no content.
  std::string freshPage(const std::string& secret) const {
    const web::Site site(rig->open(), {});
    return withoutNumber(site.answer(WebSchool::request("GET", address, secret)).body);
  }
  std::string page(const std::string& secret) const { return withoutNumber(school->get(address, secret).body); }
  std::vector<std::string> logOf(const std::string& person) const {
    std::vector<std::string> acts;
    for (const AuditEntry& entry : valueOf(AuditLog(school->admin).page(500)))
      if (entry.actor == person) acts.push_back(entry.act);
    return acts;
  }

  std::optional<WebSchool> school;
  std::string ina, admin;  ///< secrets of their sessions
  std::string address;     ///< of the class page
};
INSONATE_ON_BOTH(WebClassContents);

TEST_P(WebClassContents, UsersWithTheSamePermissionGetThePageThatTheyWouldReadThemselves) {
  const std::string first = page(ina);
  EXPECT_THAT(first, HasSubstr("Dr anna"));
  EXPECT_EQ(first, freshPage(ina));
  const std::string shared = page(admin);
  EXPECT_EQ(shared, freshPage(admin));
  EXPECT_THAT(shared, Not(HasSubstr("Dr ina")));
}

TEST_P(WebClassContents, EachChangeByAnyProgramIsSeenAtOnce) {
  const CurriculumStore elsewhere = rig->open();
  const auto by = [&](const Person& person) { return valueOf(elsewhere.signIn(person.name, kPassword)); };
  const Person admins = school->admin.person();
  const std::function<void()> changes[]{
      [&] { keepAttempt(by(school->anna)); },
      [&] {
        Person ben = school->ben;
        ben.fullName = "Benedict";
        succeed(PeopleStore(by(admins)).change(ben));
      },
      [&] { succeed(PeopleStore(by(school->anna)).changeOwnDetails("Annabel", "")); },
      [&] { succeed(CohortStore(by(admins)).join(school->spring.id, school->carl.id, false)); },
      [&] { succeed(CohortStore(by(admins)).leave(school->spring.id, school->ben.id)); },
      [&] { succeed(CohortStore(by(admins)).rename(school->spring.id, "Summer")); },
      [&] { succeed(AttemptStore(by(school->ina)).voidAttempt(school->annas, "wrong case")); }};
  std::string before = page(ina);
  for (const auto& change : changes) {
    change();
    const std::string after = page(ina);
    EXPECT_NE(after, before);
    EXPECT_EQ(after, freshPage(ina));
    EXPECT_EQ(page(admin), freshPage(admin));
    before = after;
  }
}

TEST_P(WebClassContents, TimeThatPassesIsSeen) {
  const std::string before = page(ina);
  rig->pass(60 * 86400 * kSecond_us);
  ina = school->signIn("ina");
  EXPECT_EQ(page(ina), freshPage(ina));
  EXPECT_THAT(page(ina), HasSubstr("Trainees who need attention"));
}

TEST_P(WebClassContents, AnotherUserWithoutThePermissionNeverGetsTheContent) {
  ASSERT_THAT(page(ina), HasSubstr("Dr anna"));
  const std::string otto = school->signIn("otto"), ben = school->signIn("ben");
  for (const std::string& secret : {otto, ben, std::string()}) {
    const web::Response refused = school->get(address, secret);
    EXPECT_NE(refused.status, 200);
    EXPECT_THAT(refused.body, Not(HasSubstr("Dr anna")));
  }
  succeed(CohortStore(school->admin).leave(school->spring.id, school->ina.id));
  EXPECT_EQ(school->get(address, ina).status, 404);
}

TEST_P(WebClassContents, TheLogHasEachUserAndOneEntryAnHourForRefreshes) {
  page(admin);
  page(ina);
  const std::vector<std::string> once = logOf(school->ina.id);
  EXPECT_EQ(std::ranges::count(once, "see members"), 1);
  EXPECT_EQ(std::ranges::count(once, "see cohort's attempts"), 1);
  web::Request refresh = WebSchool::request("GET", address, ina);
  refresh.headers["insonate-refresh"] = "1";
  EXPECT_EQ(school->site.answer(refresh).status, 200);
  EXPECT_EQ(logOf(school->ina.id), once);
  page(ina);
  EXPECT_EQ(logOf(school->ina.id).size(), once.size() + 2);
  rig->pass(2 * 3600 * kSecond_us);
  ina = school->signIn("ina"), admin = school->signIn("admin");
  refresh = WebSchool::request("GET", address, ina);
  page(admin);
  refresh.headers["insonate-refresh"] = "1";
  const std::size_t before = logOf(school->ina.id).size();
  EXPECT_EQ(school->site.answer(refresh).status, 200);
  EXPECT_EQ(logOf(school->ina.id).size(), before + 2);
}

}  // namespace
}  // namespace insonate::test
