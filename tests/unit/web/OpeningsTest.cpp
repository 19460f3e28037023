#include "WebRig.h"

#include <insonate/curriculum/OpeningStore.h>

#include <QDateTime>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::int64_t kHour_us = 3600 * kSecond_us;

/// The page on which tests of a class are opened and closed.
class WebOpenings : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    school.emplace(rig->open());
    tests = "/classes/" + school->spring.id + "/tests";
    ina = school->signIn("ina"), anna = school->signIn("anna"), admin = school->signIn("admin");
  }
  /// Value of a field for date and time.
  std::string hoursFromNow(int hours) const {
    return QDateTime::fromMSecsSinceEpoch((rig->now_us + hours * kHour_us) / 1000)
        .toString(QStringLiteral("yyyy-MM-ddTHH:mm"))
        .toStdString();
  }
  web::Fields form(const std::string& start, const std::string& end, const std::string& code = {},
                   const std::string& whom = "class") const {
    return {{"level", "jugular_test"}, {"whom", whom}, {"start", start}, {"end", end}, {"test-code", code}};
  }
  TestAdmission::Kind admissionOf(const Person& person) const {
    return valueOf(OpeningStore(school->as(person)).admission("central_line", "jugular_test")).kind;
  }
  std::vector<TestOpening> openings() const {
    return valueOf(OpeningStore(school->as(school->ina)).listByCohort(school->spring.id));
  }

  std::optional<WebSchool> school;
  std::string tests, ina, anna, admin;
};
INSONATE_ON_BOTH(WebOpenings);

TEST_P(WebOpenings, AnInstructorOpensAndClosesATest) {
  EXPECT_THAT(school->get(tests, ina).body, HasSubstr("attempts at tests are practice"));
  EXPECT_EQ(school->post(tests, form("", hoursFromNow(2)), anna).status, 403) << "a trainee sees no tests of a class";
  EXPECT_EQ(school->post(tests, form("", hoursFromNow(2)), school->signIn("otto")).status, 404) << "of another class";
  EXPECT_EQ(admissionOf(school->anna), TestAdmission::Kind::Closed);
  EXPECT_EQ(school->post(tests, form("", hoursFromNow(2)), ina).status, 303);
  EXPECT_EQ(admissionOf(school->anna), TestAdmission::Kind::Open);
  const std::string id = openings().front().id;
  EXPECT_THAT(school->get(tests, ina).body, AllOf(HasSubstr("<td>open</td>"), HasSubstr(id)));
  EXPECT_EQ(school->post(tests + "/close", {{"opening", id}}, anna).status, 403);
  EXPECT_EQ(admissionOf(school->anna), TestAdmission::Kind::Open);
  EXPECT_EQ(school->post(tests + "/close", {{"opening", id}}, ina).status, 303);
  EXPECT_EQ(admissionOf(school->anna), TestAdmission::Kind::Closed);
  EXPECT_THAT(school->get(tests, ina).body, HasSubstr("closed by Dr ina"));
}

TEST_P(WebOpenings, AWindowHasItsStartAndItsEndInTheTimeZoneOfTheServer) {
  const std::string page = school->get(tests, ina).body;
  const QDateTime now = QDateTime::fromMSecsSinceEpoch(rig->now_us / 1000);
  EXPECT_THAT(page, AllOf(HasSubstr("type=\"datetime-local\" name=\"start\" value=\"" + hoursFromNow(0) + "\""),
                          HasSubstr("type=\"datetime-local\" name=\"end\" value=\"" + hoursFromNow(2) + "\""),
                          HasSubstr("Start (" + now.timeZoneAbbreviation().toStdString()), Not(HasSubstr("<script"))));
  ASSERT_EQ(school->post(tests, form(hoursFromNow(3), hoursFromNow(5)), ina).status, 303);
  const TestOpening opening = openings().front();
  EXPECT_EQ(opening.start_us, rig->now_us + 3 * kHour_us);
  EXPECT_EQ(opening.end_us, rig->now_us + 5 * kHour_us);
  EXPECT_THAT(school->get(tests, ina).body, HasSubstr("<td>waiting</td>"));
  EXPECT_EQ(admissionOf(school->anna), TestAdmission::Kind::Closed);
  rig->pass(4 * kHour_us);
  EXPECT_EQ(admissionOf(school->anna), TestAdmission::Kind::Open);
  rig->pass(2 * kHour_us);
  EXPECT_EQ(admissionOf(school->anna), TestAdmission::Kind::Closed);
}

TEST_P(WebOpenings, WithoutAnEndATestNeedsACode) {
  EXPECT_THAT(school->post(tests, form("", ""), ina).body, HasSubstr("role=\"alert\""));
  EXPECT_EQ(school->post(tests, form("", "", "venus"), ina).status, 303);
  EXPECT_EQ(admissionOf(school->anna), TestAdmission::Kind::NeedsCode);
}

TEST_P(WebOpenings, TimesThatAreNoneAreRefusedAndStayInTheirFields) {
  for (const std::string time :
       {"soon", "2026-13-01T10:00", "2026-11-31T10:00", "0001-01-01T00:00", "99999-01-01T00:00"})
    for (const auto& fields : {form(time, hoursFromNow(2)), form("", time)}) {
      const web::Response refused = school->post(tests, fields, ina);
      EXPECT_EQ(refused.status, 422) << time;
      EXPECT_THAT(refused.body, AllOf(HasSubstr("is not a date with a time"), HasSubstr("value=\"" + time + "\"")));
    }
  EXPECT_EQ(school->post(tests, form(hoursFromNow(3), hoursFromNow(2)), ina).status, 422) << "ends before it starts";
  EXPECT_EQ(school->post(tests, form("", hoursFromNow(-1)), ina).status, 422) << "ended already";
  EXPECT_THAT(openings(), testing::IsEmpty());
}

TEST_P(WebOpenings, ATestThatIsOpenAlreadyIsOpenedOnlyAfterAWarning) {
  const web::Fields first = form(hoursFromNow(1), hoursFromNow(3)), later = form(hoursFromNow(4), hoursFromNow(5));
  web::Fields second = form(hoursFromNow(2), hoursFromNow(4));
  ASSERT_EQ(school->post(tests, first, ina).status, 303);
  EXPECT_EQ(school->post(tests, later, ina).status, 303) << "at another time";
  const web::Response warned = school->post(tests, second, ina);
  EXPECT_EQ(warned.status, 409);
  EXPECT_THAT(warned.body, AllOf(HasSubstr("is open already, or opens during this time"),
                                 HasSubstr("Open again</button>"), HasSubstr("value=\"" + hoursFromNow(4) + "\"")));
  EXPECT_EQ(openings().size(), 2U);
  const std::string name = "name=\"warned\" value=\"";
  const std::size_t at = warned.body.find(name) + name.size();
  second["warned"] = warned.body.substr(at, warned.body.find('"', at) - at);
  web::Fields changed = second;
  changed["end"] = hoursFromNow(6);
  EXPECT_EQ(school->post(tests, changed, ina).status, 409) << "the warning was about other times";
  EXPECT_EQ(school->post(tests, second, ina).status, 303);
  EXPECT_EQ(openings().size(), 3U);
}

TEST_P(WebOpenings, OnlyAdministratorsOpenATestForEveryone) {
  EXPECT_THAT(school->get(tests, ina).body, Not(HasSubstr(">everyone</option>")));
  EXPECT_THAT(school->get(tests, admin).body, HasSubstr(">everyone</option>"));
  const web::Fields everyone = form("", hoursFromNow(2), "", "everyone");
  EXPECT_EQ(school->post(tests, everyone, ina).status, 422);
  EXPECT_EQ(school->post(tests, form("", hoursFromNow(2), "", "others"), admin).status, 422);
  EXPECT_EQ(admissionOf(school->carl), TestAdmission::Kind::Closed);
  ASSERT_EQ(school->post(tests, everyone, admin).status, 303);
  EXPECT_EQ(admissionOf(school->carl), TestAdmission::Kind::Open);
  const std::string id = openings().front().id;
  EXPECT_NE(school->post(tests + "/close", {{"opening", id}}, ina).status, 303);
  EXPECT_EQ(admissionOf(school->carl), TestAdmission::Kind::Open);
  EXPECT_EQ(school->post(tests + "/close", {{"opening", id}}, admin).status, 303);
  EXPECT_EQ(admissionOf(school->carl), TestAdmission::Kind::Closed);
}

TEST_P(WebOpenings, TestsOfAnArchivedClassCannotBeOpened) {
  succeed(CohortStore(school->admin).archive(school->spring.id, true));
  EXPECT_THAT(school->get(tests, ina).body, AllOf(HasSubstr("is archived"), Not(HasSubstr("Open</button>"))));
  EXPECT_EQ(school->post(tests, form("", hoursFromNow(2)), ina).status, 422);
  EXPECT_THAT(school->get(tests, admin).body,
              AllOf(HasSubstr(">everyone</option>"), Not(HasSubstr("value=\"class\""))));
}

}  // namespace
}  // namespace insonate::test
