#include "StoreRig.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/BrowserSessions.h>

namespace insonate::web {

/// Takes the place of the check of ID tokens, which this program does not contain.
class IdToken {
 public:
  static VerifiedEmail verified(const std::string& email) { return VerifiedEmail(email); }
};

}  // namespace insonate::web

namespace insonate::test {
namespace {

using ::testing::HasSubstr;

class StoreSignInByProvider : public OnBoth {};
INSONATE_ON_BOTH(StoreSignInByProvider);

const std::string kAddress = "10.0.0.7";

Result<std::string> beginBy(const BrowserSessions& sessions, const std::string& email) {
  return sessions.begin(web::IdToken::verified(email), kAddress);
}

std::string nameBy(const BrowserSessions& sessions, const std::string& email) {
  const auto by = valueOf(sessions.resume(valueOf(beginBy(sessions, email))));
  return by ? by->person().name : "(none)";
}

/// Writes to the database past the program, which refuses two accounts with one address.
void writePast(const StoreRig& rig, const std::string& sql) {
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig.address)));
  if (!connection) throw std::runtime_error(connection.error().message);
  succeed((*connection)->script(sql));
}

void disable(const School& school, Person person) {
  person.disabled = true;
  succeed(PeopleStore(school.admin).change(person));
}

TEST_P(StoreSignInByProvider, BeginsASessionOfTheAccountWithTheAddress) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  EXPECT_EQ(nameBy(sessions, "anna@example.org"), "anna");
  EXPECT_EQ(nameBy(sessions, "ANNA@Example.ORG"), "anna") << "as the store compares addresses";
  const std::string secret = valueOf(beginBy(sessions, "ben@example.org"));
  EXPECT_TRUE(BrowserSessions::isByProvider(secret));
  EXPECT_FALSE(BrowserSessions::isByProvider(valueOf(sessions.begin(school.as(school.ben)))));
  succeed(sessions.end(secret));
  EXPECT_FALSE(valueOf(sessions.resume(secret)));
}

TEST_P(StoreSignInByProvider, FoldsTheCaseOfLatinLettersOnly) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  valueOf(PeopleStore(school.admin).add({"tess", "Tess", "tess@example.org"}, "first password"));
  valueOf(PeopleStore(school.admin).add({"zoe", "Zoe", "zo\xC3\xAB@example.org"}, "first password"));
  EXPECT_EQ(nameBy(sessions, "TESS@example.org"), "tess");
  EXPECT_EQ(nameBy(sessions, "zo\xC3\xAB@EXAMPLE.org"), "zoe");
  // Long s, sharp s, full-width a and a capital e with diaeresis: other mailboxes.
  for (const std::string email : {"te\xC5\xBFs@example.org", "te\xC3\x9F@example.org", "\xEF\xBD\x81nna@example.org",
                                  "zo\xC3\x8B@example.org", "anna@example.org "})
    EXPECT_THAT(refusalOf(beginBy(sessions, email)), HasSubstr("to enter this address in your account")) << email;
}

TEST_P(StoreSignInByProvider, IsRefusedWithoutExactlyOneEnabledAccount) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  for (const std::string email : {"nobody@example.org", "anna@example.org.evil", "", " "})
    EXPECT_THAT(refusalOf(beginBy(sessions, email)), HasSubstr("to enter this address in your account")) << email;
  writePast(*rig, "UPDATE people SET email = 'Anna@example.org' WHERE name = 'ben'");
  EXPECT_THAT(refusalOf(beginBy(sessions, "anna@example.org")), HasSubstr("in one account only"));
  disable(school, school.ben);
  EXPECT_EQ(nameBy(sessions, "anna@example.org"), "anna") << "the only enabled account";
  const std::string before = valueOf(beginBy(sessions, "anna@example.org"));
  disable(school, school.anna);
  EXPECT_THAT(refusalOf(beginBy(sessions, "anna@example.org")), HasSubstr("is disabled"));
  EXPECT_FALSE(valueOf(sessions.resume(before)));
}

/// Returns the latest entry before the one about reading the log.
AuditEntry lastEntry(const School& school) {
  return valueOf(AuditLog(school.admin).page(2)).back();
}

TEST_P(StoreSignInByProvider, IsInTheAuditLogAsSuch) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  (void)valueOf(beginBy(sessions, "anna@example.org"));
  AuditEntry last = lastEntry(school);
  EXPECT_EQ(std::tie(last.act, last.detail, last.actor, last.person, last.allowed),
            std::tuple("sign in", "OpenID", school.anna.id, school.anna.id, true));
  disable(school, school.ben);
  EXPECT_FALSE(beginBy(sessions, "ben@example.org"));
  last = lastEntry(school);
  EXPECT_EQ(std::tie(last.act, last.detail, last.actor, last.person, last.allowed),
            std::tuple("sign in", "OpenID", "", school.ben.id, false));
  EXPECT_FALSE(beginBy(sessions, "nobody@example.org"));
  last = lastEntry(school);
  EXPECT_EQ(std::tie(last.act, last.person, last.allowed), std::tuple("sign in", "", false));
}

TEST_P(StoreSignInByProvider, AsksForNoChangeOfAFirstPassword) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  const Person dora =
      valueOf(PeopleStore(school.admin).add({"dora", "Dora", "dora@example.org"}, "first password", school.spring.id));
  const auto withPassword = valueOf(sessions.signIn("dora", "first password", ""));
  EXPECT_TRUE(withPassword.mustChangePassword());
  EXPECT_THAT(refusalOf(AttemptStore(withPassword).history(dora.id)), HasSubstr("password of your own"));
  const std::string secret = valueOf(beginBy(sessions, "dora@example.org"));
  const SignedIn byProvider = valueOf(sessions.resume(secret)).value();
  EXPECT_FALSE(byProvider.mustChangePassword());
  EXPECT_TRUE(AttemptStore(byProvider).history(dora.id));
  succeed(PeopleStore(school.admin).resetPassword(dora.id, "another password"));
  EXPECT_FALSE(valueOf(sessions.resume(secret))) << "a new password ends all sessions";
  EXPECT_TRUE(valueOf(sessions.resume(valueOf(sessions.begin(withPassword)))) == std::nullopt);
}

TEST_P(StoreSignInByProvider, AChangedSecretBelongsToNoSession) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  valueOf(PeopleStore(school.admin).add({"dora", "Dora", "dora@example.org"}, "first password", school.spring.id));
  const std::string secret = valueOf(sessions.begin(valueOf(sessions.signIn("dora", "first password", ""))));
  EXPECT_TRUE(valueOf(sessions.resume(secret))->mustChangePassword());
  EXPECT_FALSE(valueOf(sessions.resume("openid-" + secret))) << "would not have to change the password";
}

TEST_P(StoreSignInByProvider, FailuresOfAnAddressAreLimited) {
  const School school(rig->open());
  const BrowserSessions sessions(school.store);
  for (int i = 0; i < 40; ++i) {
    succeed(sessions.countSignInAttempt(kAddress));
    (void)valueOf(beginBy(sessions, "anna@example.org"));
  }
  for (int i = 0; i < 30; ++i) {
    succeed(sessions.countSignInAttempt(kAddress));
    EXPECT_FALSE(beginBy(sessions, "nobody@example.org"));
  }
  EXPECT_THAT(refusalOf(sessions.countSignInAttempt(kAddress)),
              HasSubstr("from this network address. Try again in 60 s"));
  EXPECT_THAT(refusalOf(sessions.signIn("anna", "wrong password", kAddress)), HasSubstr("is wrong"))
      << "passwords are counted by themselves";
  (void)valueOf(sessions.signIn("anna", kPassword, kAddress));
  succeed(sessions.countSignInAttempt("10.0.0.8"));
  succeed(sessions.countSignInAttempt(""));
  rig->pass(60 * kSecond_us);
  succeed(sessions.countSignInAttempt(kAddress));
}

}  // namespace
}  // namespace insonate::test
