#include "WebRig.h"
#include "retention/DataDeletion.h"
#include "video/VideoFiles.h"

#include <insonate/curriculum/PersonData.h>
#include <insonate/curriculum/Retention.h>

#include <chrono>
#include <fstream>
#include <thread>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebPersonErasure : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    rig->services.recordings = rig->folder / "recordings";
    fs::create_directories(rig->services.recordings);
    school.emplace(rig->open());
    std::ofstream(recording()) << "motion";
    admin = school->signIn("admin");
  }
  fs::path recording() const { return rig->services.recordings / (school->annas + ".attempt"); }
  std::string account() const { return "/people/" + school->anna.id; }
  Person annaNow() const { return valueOf(PeopleStore(school->admin).person(school->anna.id)); }

  std::optional<WebSchool> school;
  std::string admin;
};
INSONATE_ON_BOTH(WebPersonErasure);

TEST_P(WebPersonErasure, APageSaysWhatIsLostAndAsksForTheName) {
  EXPECT_THAT(school->get(account(), admin).body, HasSubstr("href=\"" + account() + "/erase\""));
  EXPECT_THAT(school->get(account() + "/erase", admin).body,
              AllOf(HasSubstr("1 recording of attempts"), HasSubstr("1 attempt with points"), HasSubstr("What stays"),
                    HasSubstr("On workstations: the original recordings")));
  const web::Response wrong = school->post(account() + "/erase", {{"name", "ben"}}, admin);
  EXPECT_EQ(wrong.status, 422);
  EXPECT_THAT(wrong.body, HasSubstr("Nothing was erased."));
  EXPECT_EQ(annaNow(), school->anna);
  EXPECT_EQ(headerOf(school->post(account() + "/erase", {{"name", "anna"}}, admin), "Location"), account());
  EXPECT_FALSE(fs::exists(recording()));
  EXPECT_THAT(school->get(account(), admin).body, AllOf(HasSubstr("Erased person "), Not(HasSubstr("Dr anna"))));
  EXPECT_THAT(school->get(account() + "/erase", admin).body, HasSubstr("was erased already"));
  EXPECT_THAT(school->post(account() + "/state", {{"state", "active"}}, admin).body,
              HasSubstr("This person was erased"));
  EXPECT_THAT(school->get("/classes/" + school->spring.id, school->signIn("ina")).body, HasSubstr("Erased person "));
}

TEST_P(WebPersonErasure, AFileThatCannotBeDeletedIsTold) {
  fs::remove(recording());
  fs::create_directories(recording() / "a folder that is not empty");
  const web::Response erased = school->post(account() + "/erase", {{"name", "anna"}}, admin);
  EXPECT_EQ(erased.status, 422);
  EXPECT_THAT(erased.body,
              AllOf(HasSubstr("The person is erased. The server tries"), HasSubstr("could not be deleted")));
  EXPECT_THAT(annaNow().fullName, HasSubstr("Erased person"));
}

TEST_P(WebPersonErasure, OthersEraseNoPersonAndAnAdministratorNotThemselves) {
  for (const std::string who : {"anna", "ben", "carl", "ina", "otto"})
    EXPECT_EQ(school->post(account() + "/erase", {{"name", "anna"}}, school->signIn(who)).status, 403) << who;
  const std::string own = "/people/" + school->admin.person().id;
  EXPECT_EQ(school->post(own + "/erase", {{"name", "admin"}}, admin).status, 403);
  EXPECT_THAT(school->get(own, admin).body, Not(HasSubstr("Erase this person")));
  EXPECT_EQ(school->get("/people/' OR 1=1 --/erase", admin).status, 404);
  EXPECT_EQ(annaNow(), school->anna);
}

TEST_P(WebPersonErasure, AHostileNameIsShownAsText) {
  Person anna = school->anna;
  anna.fullName = "<script>alert(1)</script>";
  succeed(PeopleStore(school->admin).change(anna));
  EXPECT_THAT(school->get(account() + "/erase", admin).body,
              AllOf(HasSubstr("&lt;script&gt;"), Not(HasSubstr("<script>alert"))));
}

TEST_P(WebPersonErasure, TheServerDeletesVideosOfPeopleWhomAnotherProgramErased) {
  const web::WebOptions options{.videos = rig->folder / "videos"};
  const web::VideoFiles videos(options.videos);
  ASSERT_TRUE(videos.keepMoments(school->annas, {}));
  std::ofstream(videos.video(school->annas)) << "a video";
  std::ofstream(videos.video("of ben")) << "a video";
  succeed(PersonData(school->admin).erase(school->anna.id));
  std::ofstream(recording()) << "a recording in the server's folder";
  const web::DataDeletion erased(school->store, options);
  for (int i = 0; i < 1000 && videos.has(school->annas); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(videos.has(school->annas));
  EXPECT_FALSE(fs::exists(recording()));
  EXPECT_TRUE(videos.has("of ben"));
}

TEST_P(WebPersonErasure, AFileThatCannotBeDeletedKeepsNoVideosOfOthers) {
  const web::WebOptions options{.videos = rig->folder / "videos"};
  const web::VideoFiles videos(options.videos);
  const std::string bens = keepAttempt(school->as(school->ben)).id;
  fs::create_directories(rig->services.recordings / (bens + ".attempt") / "a folder that is not empty");
  rig->pass(100 * kDay_us);
  AttemptFacts recent = begunFacts();
  recent.begun_us = rig->now_us;
  rig->pass(200 * kSecond_us);
  recent = keepAttempt(school->as(school->carl), recent);
  for (const std::string& attempt : {school->annas, bens, recent.id}) {
    ASSERT_TRUE(videos.keepMoments(attempt, {}));
    std::ofstream(videos.video(attempt)) << "a video";
  }
  succeed(Retention(school->admin).setRule({.recording_months = 3}));
  (void)valueOf(Retention(school->admin).deleteExpired());
  succeed(PersonData(school->admin).erase(school->carl.id));
  const web::DataDeletion deletion(school->store, options);
  for (int i = 0; i < 500 && (videos.has(recent.id) || videos.has(bens)); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_FALSE(videos.has(school->annas)) << "of another recording";
  EXPECT_FALSE(videos.has(bens)) << "of this recording";
  EXPECT_FALSE(videos.has(recent.id)) << "of an erased person";
}

}  // namespace
}  // namespace insonate::test
