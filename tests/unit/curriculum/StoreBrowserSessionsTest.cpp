#include "StoreRig.h"

#include <insonate/curriculum/BrowserSessions.h>

namespace insonate::test {
namespace {

class StoreBrowserSessions : public OnBoth {};
INSONATE_ON_BOTH(StoreBrowserSessions);

std::string nameIn(const BrowserSessions& sessions, const std::string& secret) {
  const auto by = valueOf(sessions.resume(secret));
  return by ? by->person().name : "(none)";
}

TEST_P(StoreBrowserSessions, BelongToThePersonWhoSignedInUntilTheyEnd) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  const std::string anna = valueOf(sessions.begin(valueOf(school.store.signIn("anna", kPassword))));
  const std::string ina = valueOf(sessions.begin(valueOf(school.store.signIn("ina", kPassword))));
  EXPECT_EQ(anna.size(), 64U);
  EXPECT_EQ(nameIn(sessions, anna), "anna");
  EXPECT_EQ(nameIn(sessions, ina), "ina");
  EXPECT_EQ(nameIn(sessions, ""), "(none)");
  EXPECT_EQ(nameIn(sessions, anna.substr(1) + "x"), "(none)");
  EXPECT_EQ(nameIn(BrowserSessions(rig->open()), anna), "anna") << "another server answers";
  EXPECT_EQ(valueOf(sessions.count()), 2);
  succeed(sessions.end(anna));
  EXPECT_EQ(valueOf(sessions.count()), 1);
  EXPECT_EQ(nameIn(sessions, anna), "(none)");
  EXPECT_EQ(nameIn(sessions, ina), "ina");
}

TEST_P(StoreBrowserSessions, EndWithoutRequestsAndAfterAWorkingDay) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  const SignedIn anna = valueOf(school.store.signIn("anna", kPassword));
  const std::string idle = valueOf(sessions.begin(anna)), busy = valueOf(sessions.begin(anna));
  rig->pass(BrowserSessions::kLongestIdle_us - kSecond_us);
  EXPECT_EQ(nameIn(sessions, busy), "anna");
  rig->pass(2 * kSecond_us);
  EXPECT_EQ(nameIn(sessions, idle), "(none)");
  for (int half = 0; half < 22; ++half) {
    EXPECT_EQ(nameIn(sessions, busy), "anna") << half;
    rig->pass(BrowserSessions::kLongestIdle_us / 2);
  }
  EXPECT_EQ(nameIn(sessions, busy), "(none)") << "12 hours after its beginning";
  const std::string another = valueOf(sessions.begin(anna));
  rig->now_us -= 2 * kDay_us;
  EXPECT_EQ(nameIn(sessions, another), "(none)") << "the clock was set back";
}

TEST_P(StoreBrowserSessions, AreNotKeptAliveByAnOpenPage) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  const std::string secret = valueOf(sessions.begin(valueOf(school.store.signIn("anna", kPassword))));
  rig->pass(BrowserSessions::kLongestIdle_us - kSecond_us);
  EXPECT_TRUE(valueOf(sessions.resume(secret, false)));
  rig->pass(2 * kSecond_us);
  EXPECT_FALSE(valueOf(sessions.resume(secret, false)));
}

TEST_P(StoreBrowserSessions, EndWithAnotherPasswordAndWithTheAccount) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  const SignedIn anna = valueOf(school.store.signIn("anna", kPassword));
  const std::string here = valueOf(sessions.begin(anna)), there = valueOf(sessions.begin(anna));
  succeed(PeopleStore(valueOf(sessions.resume(here)).value()).changeOwnPassword(kPassword, "another password"));
  succeed(sessions.keepAfterPasswordChange(here));
  EXPECT_EQ(nameIn(sessions, here), "anna");
  EXPECT_EQ(nameIn(sessions, there), "(none)");
  const SignedIn withFormer = valueOf(school.store.signIn("anna", "another password"));
  succeed(PeopleStore(school.admin).resetPassword(school.anna.id, "a third password"));
  EXPECT_EQ(nameIn(sessions, here), "(none)");
  EXPECT_EQ(nameIn(sessions, valueOf(sessions.begin(withFormer))), "(none)") << "the former password opens none";
  const std::string first = valueOf(sessions.begin(valueOf(school.store.signIn("anna", "a third password"))));
  EXPECT_TRUE(valueOf(sessions.resume(first))->mustChangePassword());

  const std::string ben = valueOf(sessions.begin(valueOf(school.store.signIn("ben", kPassword))));
  Person disabled = school.ben;
  disabled.disabled = true;
  succeed(PeopleStore(school.admin).change(disabled));
  EXPECT_EQ(nameIn(sessions, ben), "(none)");
}

}  // namespace
}  // namespace insonate::test
