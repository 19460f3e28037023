#include "StoreRig.h"

#include <insonate/curriculum/OwnTraining.h>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;

class OwnTraining : public OnBoth {};
INSONATE_ON_BOTH(OwnTraining);

TEST_P(OwnTraining, OnePersonHasLevelsAtOnce) {
  const CurriculumStore store = rig->open();
  EXPECT_THAT(refusalOf(setUpOwnTraining(store, "", kPassword)), HasSubstr("Enter your name"));
  const SignedIn me = valueOf(setUpOwnTraining(store, "Ada Lovelace", kPassword));
  EXPECT_EQ(me.person().name, "ada.lovelace");
  EXPECT_EQ(me.person().fullName, "Ada Lovelace");
  const auto cohorts = valueOf(CohortStore(me).cohorts());
  ASSERT_EQ(cohorts.size(), 1U);
  EXPECT_EQ(cohorts[0].curriculum, valueOf(loadCurriculum("central_line")).name);
  const auto members = valueOf(CohortStore(me).members(cohorts[0].id));
  ASSERT_EQ(members.size(), 1U);
  EXPECT_FALSE(members[0].teaches);
  EXPECT_THAT(refusalOf(setUpOwnTraining(store, "Other", kPassword)), HasSubstr("has people already"));
}

TEST_P(OwnTraining, AClassIsJoinedLaterAndEverythingIsKept) {
  const CurriculumStore store = rig->open();
  const SignedIn me = valueOf(setUpOwnTraining(store, "Ada Lovelace", kPassword));
  const Cohort own = valueOf(CohortStore(me).cohorts()).at(0);
  AttemptFacts facts = begunFacts();
  facts.curriculum = own.curriculum, facts.curriculumVersion = own.curriculumVersion;
  facts.level = valueOf(loadCurriculum("central_line")).levels.at(0).name;
  const AttemptFacts mine = keepAttempt(me, facts);
  const std::string ids[] = {me.person().id};
  const auto before = valueOf(CohortStore(me).standings(own.id, ids));

  const Cohort spring = valueOf(CohortStore(me).add("Spring"));
  succeed(CohortStore(me).setCurriculum(spring.id, own.curriculum, own.curriculumVersion));
  succeed(CohortStore(me).join(spring.id, me.person().id, false));
  valueOf(PeopleStore(me).add({"ben", "Dr Ben", "", Role::Trainee}, "first password", spring.id));
  const auto kept = valueOf(AttemptStore(me).history(me.person().id));
  ASSERT_EQ(kept.size(), 1U);
  EXPECT_EQ(kept[0].id, mine.id);
  EXPECT_EQ(kept[0].metrics, mine.metrics);
  EXPECT_EQ(valueOf(CohortStore(me).standings(spring.id, ids)), before) << "counts in the class, too";
  EXPECT_EQ(valueOf(CohortStore(me).standings(own.id, ids)), before);
}

TEST_P(OwnTraining, ANameWithoutLatinLettersWillDo) {
  EXPECT_EQ(valueOf(setUpOwnTraining(rig->open(), "李明", kPassword)).person().name, "me");
}

TEST_P(OwnTraining, ATokenSignsInUntilItIsRevoked) {
  const CurriculumStore store = rig->open();
  const SignedIn me = valueOf(setUpOwnTraining(store, "Ada", kPassword));
  const std::string token = valueOf(PeopleStore(me).staySignedIn());
  EXPECT_EQ(valueOf(store.signInByToken(token)).person(), me.person());
  EXPECT_EQ(valueOf(store.signInByToken(token)).person(), me.person()) << "at each start of the program";
  EXPECT_THAT(refusalOf(store.signInByToken(token + "0")), HasSubstr("Sign in with your password"));
  EXPECT_THAT(refusalOf(store.signInByToken("")), HasSubstr("Sign in with your password"));
  succeed(PeopleStore(me).revokeTokens());
  EXPECT_THAT(refusalOf(store.signInByToken(token)), HasSubstr("Sign in with your password"));
}

TEST_P(OwnTraining, ANewPasswordRevokesATokenAndSoDoesADisabledAccount) {
  const School school(rig->open());
  const SignedIn anna = valueOf(school.store.signIn("anna", kPassword));
  const std::string token = valueOf(PeopleStore(anna).staySignedIn());
  EXPECT_EQ(valueOf(school.store.signInByToken(token)).person().name, "anna");
  succeed(PeopleStore(anna).changeOwnPassword(kPassword, "another long sentence"));
  EXPECT_THAT(refusalOf(school.store.signInByToken(token)), HasSubstr("Sign in with your password"));
  const std::string other = valueOf(PeopleStore(anna).staySignedIn());
  Person disabled = school.anna;
  disabled.disabled = true;
  succeed(PeopleStore(school.admin).change(disabled));
  EXPECT_THAT(refusalOf(school.store.signInByToken(other)), HasSubstr("Sign in with your password"));
}

TEST_P(OwnTraining, AGuestHasNoToken) {
  const School school(rig->open());
  EXPECT_FALSE(PeopleStore(school.store.guest()).staySignedIn());
}

}  // namespace
}  // namespace insonate::test
