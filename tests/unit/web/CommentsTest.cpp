#include "WebRig.h"
#include "comments/Comments.h"
#include "page/Page.h"

#include <insonate/curriculum/CommentStore.h>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebComments : public OnBoth {
 protected:
  web::Fields comment(const std::string& at, const std::string& text) const { return {{"at", at}, {"text", text}}; }
};
INSONATE_ON_BOTH(WebComments);

TEST_P(WebComments, AreWrittenByTheInstructorAndReadByTheTrainee) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina"), anna = school.signIn("anna"), page = "/attempts/" + school.annas;
  EXPECT_THAT(school.get(page, anna).body, Not(HasSubstr("Comments")));
  EXPECT_THAT(school.get(page, ina).body, AllOf(HasSubstr("No comments yet."), HasSubstr("0:00 to 1:02")));
  const web::Response added =
      school.post(page + "/comments?class=" + school.spring.id, comment("0:05.5", "Look <here>\nand there"), ina);
  EXPECT_EQ(headerOf(added, "Location"), page + "?class=" + school.spring.id);
  const auto unread = [&] {
    return valueOf(CommentStore(school.as(school.anna)).countsOf(school.anna.id)).at(school.annas).unread;
  };
  EXPECT_THAT(school.get(page, ina).body, AllOf(HasSubstr("0:05.5"), HasSubstr("Dr ina"),
                                                HasSubstr("Look &lt;here&gt;\nand there"), HasSubstr("/remove")));
  EXPECT_EQ(unread(), 1) << "the instructor's look does not count";
  EXPECT_THAT(school.get(page, anna).body,
              AllOf(HasSubstr("Look &lt;here&gt;"), Not(HasSubstr("Add comment")), Not(HasSubstr("/remove"))));
  EXPECT_EQ(unread(), 0);
}

TEST_P(WebComments, ARefusedOneKeepsItsTextAndSaysWhy) {
  const WebSchool school(rig->open());
  const std::string ina = school.signIn("ina"), address = "/attempts/" + school.annas + "/comments";
  for (const auto& [at, why] : std::map<std::string, std::string>{{"soon", "is not a time"},
                                                                  {"0:75", "is not a time"},
                                                                  {"-1", "is not a time"},
                                                                  {"99:00", "outside the attempt"}}) {
    const web::Response refused = school.post(address, comment(at, "My long text"), ina);
    EXPECT_EQ(refused.status, 400) << at;
    EXPECT_THAT(refused.body,
                AllOf(HasSubstr(why), HasSubstr(">My long text</textarea>"), HasSubstr("role=\"alert\"")));
  }
  EXPECT_THAT(school.post(address, comment("0", " "), ina).body, HasSubstr("The comment is empty"));
  EXPECT_THAT(valueOf(CommentStore(school.admin).listByAttempt(school.annas)), testing::IsEmpty());
}

TEST_P(WebComments, EachRoleWritesAndRemovesWhatTheDatabaseAllows) {
  const WebSchool school(rig->open());
  const std::string address = "/attempts/" + school.annas + "/comments";
  const std::string own = valueOf(CommentStore(school.as(school.ina)).add(school.annas, 0, "of Ina"));
  for (const auto& [who, status] : std::map<std::string, int>{
           {"anna", 403}, {"ben", 404}, {"carl", 404}, {"otto", 404}, {"ina", 303}, {"admin", 303}}) {
    const std::string secret = school.signIn(who);
    EXPECT_EQ(school.post(address, comment("1", "by " + who), secret).status, status) << who;
    if (who != "ina" && who != "admin") {
      EXPECT_EQ(school.post(address + "/" + own + "/remove", {}, secret).status, 403) << who;
    }
  }
  const web::Response guests = school.post(address, comment("1", "guest"));
  EXPECT_EQ(guests.status, 403);
  EXPECT_THAT(guests.body, HasSubstr("your input was not stored"));
  EXPECT_EQ(valueOf(CommentStore(school.admin).listByAttempt(school.annas)).size(), 3U);
  web::Request forged = WebSchool::request("POST", address, school.signIn("ina"));
  forged.form = comment("1", "forged");
  EXPECT_EQ(school.site.answer(forged).status, 403) << "without the code of the form";
  EXPECT_EQ(school.post(address + "/" + own + "/remove", {}, school.signIn("ina")).status, 303);
  EXPECT_THAT(school.get("/attempts/" + school.annas, school.signIn("ina")).body, Not(HasSubstr("of Ina")));
  EXPECT_EQ(school.get(address, school.signIn("ina")).status, 405);
}

TEST(WebCommentTimes, AreReadAndWrittenAsMinutesAndSeconds) {
  for (const auto& [text, time_us] : std::map<std::string, std::int64_t>{
           {"1:05", 65'000'000}, {"65", 65'000'000}, {" 0:00.5 ", 500'000}, {"0,5", 500'000}, {"12:00", 720'000'000}})
    EXPECT_EQ(valueOf(web::recordingTime(text)), time_us) << text;
  for (const std::string text : {"", "1:", ":5", "1:60", "x", "1:2:3", "1e3", "-5"})
    EXPECT_THAT(refusalOf(web::recordingTime(text)), HasSubstr("is not a time")) << text;
  EXPECT_EQ(web::recordingTimeText(0), "0:00");
  EXPECT_EQ(web::recordingTimeText(65'500'000), "1:05.5");
  EXPECT_EQ(web::recordingTimeText(754'000'000), "12:34");
}

}  // namespace
}  // namespace insonate::test
