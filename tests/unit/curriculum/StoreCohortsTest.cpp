#include "StoreRig.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/ClassImport.h>
#include <insonate/curriculum/OpeningStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/StoreUpkeep.h>

#include <algorithm>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class StoreCohorts : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    school.emplace(rig->open());
    valueOf(PublishedCurricula(school->admin).publish("central_line", 1, curriculumOf(1)));
    succeed(CohortStore(school->admin).setCurriculum(school->spring.id, "central_line", 1));
    valueOf(OpeningStore(school->as(school->ina))
                .open({.cohort = school->spring.id, .level = "jugular_test", .code = "venus"}));
  }
  TestAdmission::Kind admission() const {
    return valueOf(OpeningStore(school->as(school->anna)).admission("central_line", "jugular_test")).kind;
  }
  bool hasLogged(const std::string& words) const {
    const auto log = valueOf(AuditLog(school->admin).page(20));
    return std::ranges::any_of(log, [&](const AuditEntry& one) {
      return one.act == "change cohorts" && one.allowed && one.detail.find(words) != std::string::npos;
    });
  }
  std::optional<School> school;
};
INSONATE_ON_BOTH(StoreCohorts);

TEST_P(StoreCohorts, AnArchivedOneIsReadAndTakesNothingNew) {
  const std::string spring = school->spring.id;
  const CohortStore admin(school->admin);
  const SignedIn ina = school->as(school->ina);
  EXPECT_EQ(admission(), TestAdmission::Kind::NeedsCode);
  succeed(admin.archive(spring, true));
  EXPECT_TRUE(hasLogged("archive, cohort " + spring));
  EXPECT_EQ(valueOf(admin.cohorts()).back().id, spring) << "archived ones come last";
  EXPECT_EQ(valueOf(CohortStore(ina).members(spring)).size(), 3U);
  EXPECT_TRUE(AttemptStore(ina).history(school->anna.id));
  const std::string refusal = "The class 'Spring' is archived. An administrator can restore it.";
  EXPECT_EQ(refusalOf(admin.join(spring, school->carl.id, false)), refusal);
  EXPECT_EQ(refusalOf(PeopleStore(ina).add({"new1"}, kPassword, spring)), refusal);
  EXPECT_EQ(refusalOf(ClassImport(ina).plan(spring, {})), refusal);
  EXPECT_EQ(refusalOf(CohortStore(ina).setCurriculum(spring, "central_line", 1)), refusal);
  EXPECT_EQ(refusalOf(OpeningStore(ina).open({.cohort = spring, .level = "jugular_test", .code = "venus"})), refusal);
  EXPECT_EQ(admission(), TestAdmission::Kind::SelfAdministered) << "no instructor can open a test for her";
  const auto openings = valueOf(OpeningStore(ina).listByCohort(spring));
  ASSERT_EQ(openings.size(), 1U);
  EXPECT_TRUE(openings.front().closed_us);
  succeed(CohortStore(ina).leave(spring, school->ben.id));

  succeed(admin.archive(spring, false));
  EXPECT_TRUE(hasLogged("restore, cohort " + spring));
  EXPECT_EQ(admission(), TestAdmission::Kind::Closed);
  succeed(admin.join(spring, school->carl.id, false));
  EXPECT_THAT(refusalOf(admin.archive(freshUuid(), true)), HasSubstr("no such class"));
}

TEST_P(StoreCohorts, ADeletedOneLeavesPeopleAndAttempts) {
  const std::string spring = school->spring.id;
  const CohortStore admin(school->admin);
  const std::string attempt = keepAttempt(school->as(school->anna)).id;
  EXPECT_THAT(refusalOf(admin.remove(spring, "Autumn")), HasSubstr("'Autumn' is not the name of this class"));
  EXPECT_EQ(valueOf(admin.members(spring)).size(), 3U) << "nothing was deleted";
  succeed(admin.remove(spring, "SPRING"));
  EXPECT_TRUE(hasLogged("delete SPRING, cohort " + spring));
  const auto left = valueOf(admin.cohorts());
  ASSERT_EQ(left.size(), 1U);
  EXPECT_EQ(left.front().name, "Autumn");
  EXPECT_TRUE(AttemptStore(school->as(school->anna)).attempt(attempt));
  EXPECT_FALSE(AttemptStore(school->as(school->ina)).attempt(attempt)) << "she taught her in this class alone";
  EXPECT_THAT(valueOf(admin.listByPerson(school->anna.id)), IsEmpty());
  EXPECT_EQ(valueOf(PeopleStore(school->admin).all()).size(), 6U);
  EXPECT_THAT(refusalOf(admin.remove(spring, "Spring")), HasSubstr("no such class"));
  valueOf(admin.add("Spring"));
  EXPECT_TRUE(StoreUpkeep(school->admin).verify());
}

}  // namespace
}  // namespace insonate::test
