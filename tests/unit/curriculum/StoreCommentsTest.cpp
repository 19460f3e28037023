#include "StoreRig.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/StoreUpkeep.h>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Count = CommentStore::Count;

class StoreComments : public OnBoth {};
INSONATE_ON_BOTH(StoreComments);

TEST_P(StoreComments, TheTraineeReadsThemInTheOrderOfTheirTimes) {
  const School school(rig->open());
  const SignedIn anna = school.as(school.anna), ina = school.as(school.ina);
  const AttemptFacts attempt = keepAttempt(anna);
  const std::string late =
      valueOf(CommentStore(ina).add(attempt.id, 40 * kSecond_us, "Withdraw first, <then> redirect."));
  valueOf(CommentStore(school.admin).add(attempt.id, 3 * kSecond_us, "Good start"));
  EXPECT_EQ(valueOf(CommentStore(anna).countsOf(school.anna.id)), (std::map<std::string, Count>{{attempt.id, {2, 2}}}));
  const auto comments = valueOf(CommentStore(anna).listByAttempt(attempt.id));
  ASSERT_EQ(comments.size(), 2U);
  EXPECT_EQ(comments[0].text, "Good start");
  EXPECT_EQ(comments[1], (AttemptComment{.id = late,
                                         .attempt = attempt.id,
                                         .at_us = 40 * kSecond_us,
                                         .by = school.ina.id,
                                         .author = "Dr ina",
                                         .written_us = rig->now_us,
                                         .text = "Withdraw first, <then> redirect."}));
  EXPECT_FALSE(CommentStore(ina).markRead(attempt.id)) << "an instructor does not read for the trainee";
  succeed(CommentStore(anna).markRead(attempt.id));
  EXPECT_EQ(valueOf(CommentStore(ina).countsOf(school.anna.id)).at(attempt.id), (Count{2, 0}));
  valueOf(CommentStore(ina).add(attempt.id, 0, "One more"));
  EXPECT_EQ(valueOf(CommentStore(anna).countsOf(school.anna.id)).at(attempt.id), (Count{3, 1}));
  EXPECT_EQ(valueOf(AttemptStore(anna).attempt(attempt.id)).facts.recordingHash, attempt.recordingHash);
  EXPECT_EQ(valueOf(AuditLog(school.admin).page(2))[1].act, "write comment") << "below the look at the log itself";
  EXPECT_TRUE(AuditLog(school.admin).verify());
}

TEST_P(StoreComments, OnlyAuthorAndAdministratorRemoveAComment) {
  const School school(rig->open());
  const Person uta = school.add("uta", Role::Instructor, school.spring.id);
  const SignedIn ina = school.as(school.ina);
  const AttemptFacts attempt = keepAttempt(school.as(school.anna));
  const std::string first = valueOf(CommentStore(ina).add(attempt.id, 0, "first"));
  const std::string second = valueOf(CommentStore(ina).add(attempt.id, 0, "second"));
  EXPECT_THAT(refusalOf(CommentStore(school.as(uta)).remove(attempt.id, first)),
              HasSubstr("author or an administrator"));
  EXPECT_THAT(refusalOf(CommentStore(school.as(school.anna)).remove(attempt.id, first)), HasSubstr("permission"));
  succeed(CommentStore(ina).remove(attempt.id, first));
  succeed(CommentStore(ina).remove(attempt.id, first));
  succeed(CommentStore(school.admin).remove(attempt.id, second));
  EXPECT_THAT(valueOf(CommentStore(ina).listByAttempt(attempt.id)), IsEmpty());
  EXPECT_THAT(valueOf(CommentStore(ina).countsOf(school.anna.id)), IsEmpty());
  EXPECT_THAT(refusalOf(CommentStore(ina).remove(attempt.id, freshUuid())), HasSubstr("no such comment"));
}

TEST_P(StoreComments, BadTextAndTimesAreRefused) {
  const School school(rig->open());
  const CommentStore comments(school.as(school.ina));
  const AttemptFacts attempt = keepAttempt(school.as(school.anna));
  EXPECT_THAT(refusalOf(comments.add(attempt.id, 0, " \n")), HasSubstr("empty"));
  EXPECT_FALSE(comments.add(attempt.id, 0, std::string(4001, 'x')));
  EXPECT_FALSE(comments.add(attempt.id, 0, "\xFF"));
  EXPECT_THAT(refusalOf(comments.add(attempt.id, 63 * kSecond_us, "late")), HasSubstr("takes 62 s"));
  EXPECT_THAT(refusalOf(comments.add(attempt.id, -1, "early")), HasSubstr("outside the attempt"));
  const AttemptFacts open = begunFacts();
  valueOf(AttemptStore(school.as(school.anna)).begin(open));
  EXPECT_THAT(refusalOf(comments.add(open.id, 0, "now")), HasSubstr("still open"));
}

TEST_P(StoreComments, ACommentIsNotChangedPastTheProgram) {
  const School school(rig->open());
  const AttemptFacts attempt = keepAttempt(school.as(school.anna));
  valueOf(CommentStore(school.as(school.ina)).add(attempt.id, 0, "text"));
  const auto connection = valueOf(store::Address::parse(rig->address));
  for (const std::string sql : {"UPDATE comments SET text = 'other'", "DELETE FROM comments",
                                "UPDATE comments SET at_us = 1", "UPDATE comments SET author = ''"})
    EXPECT_FALSE((*store::Connection::open(connection))->script(sql)) << sql;
  EXPECT_TRUE((*store::Connection::open(connection))->script("UPDATE comments SET read_us = 1"));
  EXPECT_FALSE((*store::Connection::open(connection))->script("UPDATE comments SET read_us = NULL"));
}

TEST_P(StoreComments, TheyGoToTheServerAndComeBackWithWhatWasDoneThere) {
  rig->services.workstation = "server";
  const School school(rig->open());
  StoreRig ward;
  const CurriculumStore near = ward.open();
  const SiteUpload upload(near, school.store);
  valueOf(upload.exchange());
  const auto here = [&](const Person& person) { return valueOf(near.signIn(person.name, kPassword)); };
  const AttemptFacts attempt = keepAttempt(here(school.anna));
  const std::string own = valueOf(CommentStore(here(school.ina)).add(attempt.id, 0, "from the ward"));
  valueOf(upload.exchange());
  EXPECT_EQ(valueOf(CommentStore(school.admin).listByAttempt(attempt.id)).at(0).text, "from the ward");
  valueOf(CommentStore(school.as(school.ina)).add(attempt.id, 1, "from the server"));
  succeed(CommentStore(school.admin).remove(attempt.id, own));
  valueOf(upload.exchange());
  const auto comments = valueOf(CommentStore(here(school.anna)).listByAttempt(attempt.id));
  ASSERT_EQ(comments.size(), 1U);
  EXPECT_EQ(comments[0].text, "from the server");
  succeed(CommentStore(here(school.anna)).markRead(attempt.id));
  valueOf(upload.exchange());
  EXPECT_TRUE(valueOf(CommentStore(school.admin).listByAttempt(attempt.id)).at(0).isRead);
}

}  // namespace
}  // namespace insonate::test
