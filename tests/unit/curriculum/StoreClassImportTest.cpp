#include "StoreRig.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/ClassImport.h>
#include <insonate/curriculum/Csv.h>

#include <algorithm>
#include <filesystem>

namespace insonate::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using enum ClassImportRow::Step;

/// A class list that becomes people of a class.
class StoreClassImport : public OnBoth {
 protected:
  static ClassList listOf(const std::string& lines) {
    return valueOf(parseClassList("full name,username,e-mail\n" + lines));
  }
  static std::vector<ClassImportRow::Step> stepsOf(const std::vector<ClassImportRow>& plan) {
    std::vector<ClassImportRow::Step> steps;
    for (const ClassImportRow& row : plan) steps.push_back(row.step);
    return steps;
  }
  static std::vector<std::string> learners(const SignedIn& by, const Cohort& cohort) {
    std::vector<std::string> names;
    for (const Member& member : valueOf(CohortStore(by).members(cohort.id)))
      if (!member.teaches) names.push_back(member.person.name);
    return names;
  }
};
INSONATE_ON_BOTH(StoreClassImport);

TEST_P(StoreClassImport, APlanTellsWhatBecomesOfEachLineAndChangesNothing) {
  const School school(rig->open());
  const ClassImport import(school.admin);
  const auto plan =
      valueOf(import.plan(school.spring.id, listOf("Zoe,zoe,\nNobody,,\nDr anna,anna,\nDr carl,carl,\n")));
  EXPECT_THAT(stepsOf(plan), ElementsAre(Add, Refuse, AlreadyThere, Join));
  EXPECT_THAT(plan[1].why, HasSubstr("Line 3: There is neither user name"));
  EXPECT_EQ(plan[1].person.fullName, "Nobody") << "who is refused is named";
  EXPECT_THAT(learners(school.admin, school.spring), ElementsAre("anna", "ben"));
}

TEST_P(StoreClassImport, ItIsCarriedOutAndEachMustChooseAPassword) {
  const School school(rig->open());
  const ClassImport import(school.admin);
  const auto plan = valueOf(import.plan(school.spring.id, listOf("Zoe,zoe,\nDr carl,carl,\nYan,yan,\n")));
  const auto passwords = ClassImport::passwordsFor(plan);
  ASSERT_EQ(passwords.size(), 2U);
  succeed(import.apply(school.spring.id, plan, passwords));
  EXPECT_THAT(learners(school.admin, school.spring), ElementsAre("anna", "ben", "carl", "yan", "zoe"));
  const SignedIn zoe = valueOf(school.store.signIn("zoe", passwords[0].password));
  EXPECT_TRUE(zoe.mustChangePassword());
  EXPECT_EQ(zoe.person().role, Role::Trainee);
  EXPECT_TRUE(valueOf(school.store.signIn("yan", passwords[1].password)).mustChangePassword());
  const auto again = valueOf(import.plan(school.spring.id, listOf("Zoe,zoe,\nDr carl,carl,\n")));
  EXPECT_THAT(stepsOf(again), ElementsAre(AlreadyThere, AlreadyThere));
  int logged = 0;
  for (const AuditEntry& entry : valueOf(AuditLog(school.admin).page(100, 0, zoe.person().id))) {
    logged += entry.act == "add trainee" && entry.detail.starts_with(zoe.person().id + ", trainee");
    EXPECT_THAT(entry.detail, ::testing::Not(::testing::HasSubstr("zoe"))) << "a name in the log could not be erased";
  }
  EXPECT_EQ(logged, 1) << "each person is an entry of the log";
}

TEST_P(StoreClassImport, AllOrNothing) {
  const School school(rig->open());
  const ClassImport import(school.admin);
  const auto plan = valueOf(import.plan(school.spring.id, listOf("Zoe,zoe,\nYan,yan,\n")));
  const auto passwords = ClassImport::passwordsFor(plan);
  school.add("yan", Role::Trainee, school.autumn.id);
  EXPECT_THAT(refusalOf(import.apply(school.spring.id, plan, passwords)),
              AllOf(HasSubstr("Line 3"), HasSubstr("'yan' already"), HasSubstr("Nobody was added")));
  EXPECT_THAT(learners(school.admin, school.spring), ElementsAre("anna", "ben"));
  EXPECT_FALSE(school.store.signIn("zoe", passwords[0].password));
  int reports = 0;
  const auto stop = [&](std::string_view, double) { return ++reports < 2; };
  const auto fresh = valueOf(import.plan(school.spring.id, listOf("Zoe,zoe,\nXan,xan,\n")));
  EXPECT_EQ(refusalOf(import.apply(school.spring.id, fresh, ClassImport::passwordsFor(fresh), stop)), kCancelled);
  EXPECT_THAT(learners(school.admin, school.spring), ElementsAre("anna", "ben"));
  EXPECT_THAT(refusalOf(import.apply(school.spring.id, fresh, {})), HasSubstr("0 passwords for 2"));
}

TEST_P(StoreClassImport, AnInstructorAddsToTheOwnClassAndPutsNobodyIntoIt) {
  const School school(rig->open());
  const ClassImport ina(school.as(school.ina));
  const auto plan = valueOf(ina.plan(school.spring.id, listOf("Zoe,zoe,\nDr carl,carl,\nDr ben,ben,\n")));
  EXPECT_THAT(stepsOf(plan), ElementsAre(Add, Refuse, AlreadyThere));
  EXPECT_THAT(plan[1].why, HasSubstr("'carl' already")) << "whom ina does not see";
  succeed(ina.apply(school.spring.id, plan, ClassImport::passwordsFor(plan)));
  EXPECT_THAT(learners(school.admin, school.spring), ElementsAre("anna", "ben", "zoe"));

  EXPECT_FALSE(ina.plan(school.autumn.id, listOf("Xan,xan,\n")));
  const auto own = valueOf(ina.plan(school.spring.id, listOf("Xan,xan,\n")));
  EXPECT_FALSE(ina.apply(school.autumn.id, own, ClassImport::passwordsFor(own))) << "a plan is no right";
  auto forged = own;
  forged.front().step = Join, forged.front().id = school.carl.id;
  EXPECT_THAT(refusalOf(ina.apply(school.spring.id, forged, {})), HasSubstr("do not have the permission"));
  EXPECT_FALSE(ClassImport(school.as(school.anna)).plan(school.spring.id, {}));
  EXPECT_EQ(std::ranges::count(valueOf(AuditLog(school.admin).page(20)), false, &AuditEntry::allowed), 4)
      << "each refusal is an entry of the log";
  EXPECT_THAT(learners(school.admin, school.autumn), ElementsAre("carl"));
}

TEST_P(StoreClassImport, AnEmailAddressOfAnUnseenAccountIsRefused) {
  const School school(rig->open());
  const ClassImport ina(school.as(school.ina));
  const auto plan = valueOf(ina.plan(school.spring.id, listOf("Carl,carl2,CARL@example.org\nZoe,zoe,zoe@x.org\n")));
  EXPECT_THAT(stepsOf(plan), ElementsAre(Refuse, Add));
  EXPECT_THAT(plan[0].why, AllOf(HasSubstr("Line 2: The e-mail address CARL@example.org belongs to an account"),
                                 Not(HasSubstr("Dr carl"))));
  valueOf(PeopleStore(school.admin).add({"zoe2", "Zoe", "zoe@x.org", Role::Trainee}, "first password"));
  EXPECT_THAT(refusalOf(ina.apply(school.spring.id, plan, ClassImport::passwordsFor(plan))),
              AllOf(HasSubstr("Line 3: The e-mail address zoe@x.org"), HasSubstr("Nobody was added")));
}

TEST_P(StoreClassImport, DisabledPeopleAreNamed) {
  const School school(rig->open());
  for (Person person : {school.anna, school.carl}) {
    person.disabled = true;
    succeed(PeopleStore(school.admin).change(person));
  }
  const auto plan =
      valueOf(ClassImport(school.admin).plan(school.spring.id, listOf("Dr anna,anna,\nDr ben,ben,\nDr carl,carl,\n")));
  EXPECT_THAT(stepsOf(plan), ElementsAre(Refuse, AlreadyThere, Refuse));
  EXPECT_THAT(plan[0].why, HasSubstr("The account of Dr anna, who is already in the class, is disabled"));
  EXPECT_THAT(plan[2].why, HasSubstr("The account of Dr carl is disabled"));
}

TEST_P(StoreClassImport, ANameWithASignIsReadBackFromThePasswordFile) {
  const School school(rig->open());
  const ClassImport import(school.admin);
  const auto plan = valueOf(import.plan(school.spring.id, listOf("Max,-max,\n")));
  const auto passwords = ClassImport::passwordsFor(plan);
  succeed(import.apply(school.spring.id, plan, passwords));
  const TemporaryFolder folder;
  const auto file = folder / "first.csv";
  succeed(writeFirstPasswords(file, passwords));
  const std::string text = bytesOf(file);
  EXPECT_THAT(text, AllOf(HasSubstr("\r\n\u00A0-max,"), Not(HasSubstr("'"))));
  const auto rows = valueOf(parseCsv(text));
  EXPECT_EQ(valueOf(school.store.signIn(rows.at(1).fields.at(0), rows[1].fields.at(3))).person().name, "-max");
  EXPECT_EQ(valueOf(parseClassList("full name,username\nMax," + rows[1].fields[0])).entries.at(0).person.name, "-max");
}

TEST(FirstPasswords, AreWrittenOnceForTheOwnerAlone) {
  const TemporaryFolder folder;
  const auto file = folder / "first.csv";
  const std::vector<FirstPassword> passwords{{{.name = "zoe", .fullName = "=cmd()"}, "abcd-efgh-jkmn"}};
  succeed(writeFirstPasswords(file, passwords));
  EXPECT_EQ(std::filesystem::status(file).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  EXPECT_THAT(refusalOf(writeFirstPasswords(file, {})), HasSubstr("exists"));
}

}  // namespace
}  // namespace insonate::test
