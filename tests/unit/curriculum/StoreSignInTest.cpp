#include "StoreRig.h"
#include "store/Passwords.h"

#include <insonate/curriculum/AuditLog.h>

#include <atomic>
#include <set>
#include <thread>
#include <vector>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;

class StoreSignIn : public OnBoth {};
INSONATE_ON_BOTH(StoreSignIn);

TEST_P(StoreSignIn, TheFirstRunAsksForAnAdministratorAndNoOther) {
  const CurriculumStore store = rig->open();
  EXPECT_FALSE(valueOf(store.hasPeople()));
  EXPECT_THAT(refusalOf(store.createFirstAdministrator({"admin"}, "short")), HasSubstr("8 to 200"));
  const SignedIn admin = valueOf(store.createFirstAdministrator({"Admin", "Ada", "a@b"}, kPassword));
  EXPECT_EQ(admin.person().role, Role::Administrator);
  EXPECT_TRUE(valueOf(store.hasPeople()));
  EXPECT_THAT(refusalOf(store.createFirstAdministrator({"other"}, kPassword)), HasSubstr("has people already"));
  EXPECT_EQ(valueOf(PeopleStore(admin).all()).size(), 1U);
}

TEST_P(StoreSignIn, NamesKeepTheirCaseAndAreFoundInAny) {
  const CurriculumStore store = rig->open();
  valueOf(store.createFirstAdministrator({"Admin"}, kPassword));
  EXPECT_EQ(valueOf(store.signIn("aDMIN", kPassword)).person().name, "Admin");
}

TEST_P(StoreSignIn, ARefusalDoesNotTellWhatWasWrong) {
  const School school(rig->open());
  Person ben = school.ben;
  ben.disabled = true;
  succeed(PeopleStore(school.admin).change(ben));
  std::set<std::string> sentences;
  sentences.insert(refusalOf(school.store.signIn("anna", "wrong password")));
  sentences.insert(refusalOf(school.store.signIn("nobody", "wrong password")));
  sentences.insert(refusalOf(school.store.signIn("ben", kPassword)));
  sentences.insert(refusalOf(school.store.signIn("", "")));
  sentences.insert(refusalOf(school.store.signIn(std::string("a\0b", 3), kPassword)));
  sentences.insert(refusalOf(school.store.signIn("anna", "\xff\xfe")));
  EXPECT_EQ(sentences, std::set<std::string>{"The name or the password is wrong, or the account is disabled."});
}

TEST(StoreSignInCost, WhoIsUnknownCostsAsMuchAsWhoIsKnown) {
  const auto costOf = [](const std::string& hashed) { return hashed.substr(0, hashed.find('$', hashed.find("m="))); };
  for (const PasswordCost cost : {PasswordCost::Default, PasswordCost::Minimum})
    EXPECT_EQ(costOf(store::hashOfNobody(cost)), costOf(valueOf(store::hashedPassword(kPassword, cost))));
  EXPECT_EQ(costOf(store::hashOfNobody(PasswordCost::Default)), "$argon2id$v=19$m=65536,t=2,p=1");
}

TEST_P(StoreSignIn, GuessingIsLockedOutLongerAndLongerWhetherTheNameExistsOrNot) {
  const School school(rig->open());
  for (const std::string name : {"anna", "nobody"}) {
    SCOPED_TRACE(name);
    for (int i = 0; i < 5; ++i)
      EXPECT_THAT(refusalOf(school.store.signIn(name, "wrong password")), HasSubstr("is wrong"));
    for (const int wait_s : {30, 60, 120, 240, 480, 960, 1920, 3600, 3600}) {
      EXPECT_THAT(refusalOf(school.store.signIn(name, kPassword)), HasSubstr("in " + std::to_string(wait_s) + " s"));
      rig->pass(wait_s * kSecond_us - 1);
      EXPECT_THAT(refusalOf(school.store.signIn(name, kPassword)), HasSubstr("in 1 s"));
      rig->pass(1);
      EXPECT_THAT(refusalOf(school.store.signIn(name, "wrong password")), HasSubstr("is wrong"));
    }
  }
  rig->pass(3600 * kSecond_us);
  EXPECT_TRUE(school.store.signIn("anna", kPassword)) << "a lock ends by itself";
  EXPECT_THAT(refusalOf(school.store.signIn("anna", "wrong password")), HasSubstr("is wrong")) << "and is forgotten";
}

/// Signs in with this password in many threads at once, and counts the answers that begin with `answer`.
int answersAtOnce(const CurriculumStore& store, const std::string& password, const std::string& answer) {
  std::atomic<int> count{0};
  std::vector<std::thread> people;
  for (int i = 0; i < 16; ++i)
    people.emplace_back([&] {
      const auto by = store.signIn("anna", password);
      count += (by ? "signed in" : by.error().message).starts_with(answer);
    });
  for (std::thread& one : people) one.join();
  return count;
}

TEST_P(StoreSignIn, RightPasswordsAtOnceAreNotTakenForGuesses) {
  const School school(rig->open());
  EXPECT_EQ(answersAtOnce(school.store, kPassword, "signed in"), 16);
}

TEST_P(StoreSignIn, WrongPasswordsAtOnceGainNothing) {
  const School school(rig->open());
  EXPECT_EQ(answersAtOnce(school.store, "wrong password", "The name or the password is wrong"), 5);
  EXPECT_THAT(refusalOf(school.store.signIn("anna", kPassword)), HasSubstr("in 30 s"));
}

TEST_P(StoreSignIn, LockOutsSurviveRestartsAndClocksThatJump) {
  const School school(rig->open());
  for (int i = 0; i < 5; ++i) (void)school.store.signIn("anna", "wrong password");
  rig->now_us += 400 * kDay_us;
  EXPECT_THAT(refusalOf(school.store.signIn("anna", kPassword)), HasSubstr("in 30 s")) << "the clock was set forward";
  rig->now_us -= 800 * kDay_us;
  EXPECT_THAT(refusalOf(rig->open().signIn("anna", kPassword)), HasSubstr("in 30 s"))
      << "and back, another program asks";

  rig->services.boot = "second boot";
  rig->up_us = 10 * kSecond_us;
  const CurriculumStore restarted = rig->open();
  EXPECT_THAT(refusalOf(restarted.signIn("anna", kPassword)), HasSubstr("in 30 s"))
      << "restarted with the clock far back";
  rig->pass(29 * kSecond_us);
  EXPECT_THAT(refusalOf(restarted.signIn("anna", kPassword)), HasSubstr("in 1 s"));
  rig->pass(1 * kSecond_us);
  EXPECT_TRUE(restarted.signIn("anna", kPassword)) << "never longer than a lock is";
}

TEST_P(StoreSignIn, AForgottenPasswordIsResetAndChangedAtTheNextSignIn) {
  const School school(rig->open());
  const SignedIn before = school.as(school.anna);
  for (int i = 0; i < 6; ++i) (void)school.store.signIn("anna", "wrong password");
  succeed(PeopleStore(school.as(school.ina)).resetPassword(school.anna.id, "temporary one"));

  EXPECT_THAT(refusalOf(AttemptStore(before).history(school.anna.id)), HasSubstr("was reset"));
  const SignedIn anna = valueOf(school.store.signIn("anna", "temporary one"));
  EXPECT_TRUE(anna.mustChangePassword());
  EXPECT_THAT(refusalOf(AttemptStore(anna).history(school.anna.id)), HasSubstr("password of your own"));
  EXPECT_THAT(refusalOf(PeopleStore(anna).changeOwnPassword("temporary one", "temporary one")),
              HasSubstr("is the same as the old one"));
  EXPECT_THAT(refusalOf(PeopleStore(anna).changeOwnPassword("wrong password", kPassword)), HasSubstr("is wrong"));
  succeed(PeopleStore(anna).changeOwnPassword("temporary one", kPassword));
  EXPECT_FALSE(anna.mustChangePassword());
  EXPECT_TRUE(AttemptStore(anna).history(school.anna.id)) << "the session goes on";
}

TEST_P(StoreSignIn, GuessingTheOldPasswordIsLockedOutToo) {
  const School school(rig->open());
  const PeopleStore anna(school.as(school.anna));
  for (int i = 0; i < 5; ++i)
    EXPECT_THAT(refusalOf(anna.changeOwnPassword("wrong password", "another one")), HasSubstr("is wrong"));
  EXPECT_THAT(refusalOf(anna.changeOwnPassword(kPassword, "another one")), HasSubstr("too many"));
}

TEST_P(StoreSignIn, RolesAndDisablingHoldForSessionsThatAreOpen) {
  const School school(rig->open());
  const SignedIn ina = school.as(school.ina), anna = school.as(school.anna);
  EXPECT_TRUE(CohortStore(ina).members(school.spring.id));
  Person changed = school.ina;
  changed.role = Role::Trainee;
  succeed(PeopleStore(school.admin).change(changed));
  EXPECT_FALSE(CohortStore(ina).members(school.spring.id));
  changed = school.anna;
  changed.disabled = true;
  succeed(PeopleStore(school.admin).change(changed));
  EXPECT_THAT(refusalOf(AttemptStore(anna).history(changed.id)), HasSubstr("disabled"));
}

TEST_P(StoreSignIn, TheLastAdministratorStays) {
  const School school(rig->open());
  const PeopleStore people(school.admin);
  Person admin = school.admin.person();
  admin.disabled = true;
  EXPECT_THAT(refusalOf(people.change(admin)), HasSubstr("the last administrator"));
  admin = school.admin.person();
  admin.role = Role::Instructor;
  EXPECT_THAT(refusalOf(people.change(admin)), HasSubstr("the last administrator"));
  Person ina = school.ina;
  ina.role = Role::Administrator;
  ina.disabled = true;
  succeed(people.change(ina));
  EXPECT_THAT(refusalOf(people.change(admin)), HasSubstr("the last administrator"))
      << "one who cannot sign in does not count";
  ina.disabled = false;
  succeed(people.change(ina));
  succeed(people.change(admin));
}

TEST_P(StoreSignIn, NamesThatLookAlikeAreRefused) {
  const School school(rig->open());
  const PeopleStore people(school.admin);
  const auto refusal = [&](const std::string& name) { return refusalOf(people.add({name}, kPassword)); };
  EXPECT_THAT(refusal("ANNA"), HasSubstr("already"));
  EXPECT_THAT(refusal("ａｎｎａ"), HasSubstr("already")) << "full-width letters";
  EXPECT_THAT(refusal("аnna"), HasSubstr("two alphabets")) << "a Cyrillic a";
  EXPECT_THAT(refusal("an na"), HasSubstr("no spaces"));
  EXPECT_THAT(refusal("anna\u200b"), HasSubstr("no spaces")) << "a space of no width";
  EXPECT_THAT(refusal("\u202eanna"), HasSubstr("no spaces")) << "turned to be read from the right";
  EXPECT_THAT(refusal(""), HasSubstr("1 to 64"));
  EXPECT_THAT(refusal(std::string(65, 'a')), HasSubstr("1 to 64"));
  EXPECT_THAT(refusal(std::string(1'000'000, 'a')), HasSubstr("Shorten"));
  EXPECT_THAT(refusal("a\xff"), HasSubstr("UTF-8"));
  EXPECT_THAT(refusal(std::string("a\0b", 3)), HasSubstr("zero byte"));
  for (const std::string name : {"анна", "Łukasz", "العربية", "小林", "o.brien+x_1@clinic.example-1.org"}) {
    EXPECT_TRUE(people.add({name}, kPassword)) << name;
    EXPECT_TRUE(school.store.signIn(name, kPassword)) << name;
  }
}

TEST_P(StoreSignIn, SigningInIsLoggedWithoutWhatWasTyped) {
  const School school(rig->open());
  (void)school.store.signIn("my secret password", "my secret password");
  (void)school.store.signIn("anna", "wrong password");
  const auto log = valueOf(AuditLog(school.admin).page(3));
  EXPECT_EQ(log[2].act, "sign in");
  EXPECT_FALSE(log[2].allowed);
  EXPECT_EQ(log[2].person + log[2].actor + log[2].detail, "");
  EXPECT_EQ(log[1].person, school.anna.id);
  EXPECT_FALSE(log[1].allowed);
}

}  // namespace
}  // namespace insonate::test
