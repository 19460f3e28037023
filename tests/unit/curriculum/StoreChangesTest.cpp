#include "StoreRig.h"

#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/PersonData.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Retention.h>
#include <insonate/curriculum/StoreChanges.h>

namespace insonate::test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class StoreChangesTest : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    school.emplace(rig->open());
    changes.emplace(school->as(school->ina));
    EXPECT_THAT(valueOf(changes->readChanges()), IsEmpty()) << "the first call only begins";
  }
  std::optional<School> school;
  std::optional<StoreChanges> changes;
};
INSONATE_ON_BOTH(StoreChangesTest);

TEST_P(StoreChangesTest, NameThePeopleConcernedOnce) {
  const AttemptFacts facts = keepAttempt(school->as(school->anna));
  EXPECT_THAT(valueOf(changes->readChanges()), ElementsAre(school->anna.id));
  EXPECT_THAT(valueOf(changes->readChanges()), IsEmpty());
  valueOf(CommentStore(school->as(school->ina)).add(facts.id, 0, "Steeper"));
  EXPECT_THAT(valueOf(changes->readChanges()), ElementsAre(school->anna.id));
  succeed(AttemptStore(school->as(school->ina)).voidAttempt(facts.id, "device failed"));
  keepAttempt(school->as(school->carl));
  std::set<std::string> both{school->anna.id, school->carl.id};
  EXPECT_EQ(valueOf(changes->readChanges()), both);
}

TEST_P(StoreChangesTest, AreSeenFromAnotherProgramToo) {
  keepAttempt(valueOf(rig->open().signIn("ben", kPassword)));
  EXPECT_THAT(valueOf(changes->readChanges()), ElementsAre(school->ben.id));
}

TEST_P(StoreChangesTest, AClassConcernsNoPersonInParticular) {
  valueOf(CohortStore(school->admin).add("Summer"));
  EXPECT_TRUE(valueOf(changes->readChanges()).contains(""));
}

TEST_P(StoreChangesTest, SigningInAndSeeingChangeNothing) {
  const int version = valueOf(loadCurriculum("central_line")).version;
  valueOf(PublishedCurricula(school->admin).publish("central_line", version, curriculumOf(version)));
  succeed(CohortStore(school->admin).setCurriculum(school->spring.id, "central_line", version));
  keepAttempt(school->as(school->anna));
  EXPECT_FALSE(valueOf(changes->readChanges()).empty());
  const SignedIn ina = school->as(school->ina);
  valueOf(CohortStore(ina).members(school->spring.id));
  const std::vector<std::string> people{school->anna.id};
  valueOf(CohortStore(ina).standings(school->spring.id, people));
  valueOf(AttemptStore(ina).history(school->anna.id));
  valueOf(AttemptStore(ina).recentOfCohort(school->spring.id, 5));
  EXPECT_FALSE(CohortStore(school->as(school->anna)).add("Anna's own")) << "refused, and in the log";
  EXPECT_THAT(valueOf(changes->readChanges()), IsEmpty());
}

TEST_P(StoreChangesTest, ADownloadAndARuleOfRetentionChangeNoPage) {
  valueOf(PersonData(school->as(school->anna)).exportTo(school->anna.id, rig->folder / "data.zip"));
  succeed(Retention(school->admin).setRule({.erase_months = 3}));
  valueOf(Retention(school->admin).preview({.erase_months = 4}));
  EXPECT_THAT(valueOf(changes->readChanges()), IsEmpty());
  rig->pass(100 * kDay_us);
  EXPECT_EQ(valueOf(Retention(school->admin).deleteExpired()).trainees.size(), 3U);
  EXPECT_TRUE(valueOf(changes->readChanges()).contains(school->anna.id)) << "an erasure does";
}

TEST_P(StoreChangesTest, ManyAreAChangeOfEverything) {
  const SignedIn anna = school->as(school->anna);
  for (int i = 0; i < 501; ++i) keepAttempt(anna);
  EXPECT_THAT(valueOf(changes->readChanges()), ElementsAre(""));
}

}  // namespace
}  // namespace insonate::test
