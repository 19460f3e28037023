#include "WebRig.h"
#include "support/SmallCase.h"
#include "video/VideoFiles.h"
#include "video/VideoMaker.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/PersonData.h>
#include <insonate/simulator/ScriptedSession.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <thread>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// A class whose attempt has a recording, and may have a video.
class WebVideo : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    rig->services.recordings = rig->folder / "recordings";
    fs::create_directories(rig->services.recordings);
    options.videos = rig->folder / "videos";
    options.cases = rig->folder / "cases";
    school.emplace(rig->open(), options);
    address = "/attempts/" + school->annas;
  }
  /// Puts a recording in place, as a workstation sends it: a needle into the vein of a block.
  void putRecording() const {
    const PatientCase patient = smallAttemptCase();
    const auto script = readSessionScript(
        R"({"acts": [{"probe": {"position_mm": [0, 0.5, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}},
                     {"needle": {"from_mm": [-8, -3, 0], "to": "vein"}}, {"wait_s": 0.1},
                     {"advance_mm": 19, "speed_mmps": 100}, {"freeze": true}, {"wait_s": 0.1}]})",
        patient);
    ASSERT_TRUE(script) << script.error().message;
    ASSERT_TRUE(runSession(*script, patient, "insonate test", recording()));
  }
  fs::path recording() const { return rig->services.recordings / (school->annas + ".attempt"); }
  void putVideo() const {
    const web::VideoFiles files(options.videos);
    ASSERT_TRUE(files.keepMoments(
        school->annas,
        {{.time_us = 1'500'000, .description = "The skin <was> punctured.", .severity = {}},
         {.time_us = 2'000'000, .description = "The artery was punctured.", .severity = Severity::Critical}}));
    std::ofstream(files.video(school->annas)) << "0123456789";
  }

  web::WebOptions options;
  std::optional<WebSchool> school;
  std::string address;
};
INSONATE_ON_BOTH(WebVideo);

TEST_P(WebVideo, ThePageOffersAVideoWhereThereIsARecording) {
  const std::string anna = school->signIn("anna");
  EXPECT_THAT(school->get(address, anna).body, Not(HasSubstr("Make video")));
  EXPECT_EQ(school->post(address + "/video", {}, anna).status, 404) << "there is no recording";
  std::ofstream(recording()) << "a recording";
  EXPECT_THAT(school->get(address, anna).body, HasSubstr("Make video"));
  EXPECT_EQ(school->post(address + "/video", {}, school->signIn("ben")).status, 404);
  EXPECT_EQ(valueOf(VideoQueue(school->store, "server").waiting()), 0) << "ben may not see it";
  const web::Response asked = school->post(address + "/video", {}, anna);
  EXPECT_EQ(asked.status, 303);
  EXPECT_EQ(headerOf(asked, "Location"), address + "/video");
  const web::Response progress = school->get(address + "/video", anna);
  EXPECT_EQ(headerOf(progress, "Refresh"), "3");
  EXPECT_THAT(progress.body, HasSubstr("The server makes the video now; this takes about"));
  const VideoQueue queue(school->store, "server");
  ASSERT_TRUE(valueOf(queue.takeNext()));
  rig->pass(30 * kSecond_us);
  ASSERT_TRUE(valueOf(queue.reportProgress(school->annas, 0.25)));
  EXPECT_THAT(school->get(address + "/video", anna).body, HasSubstr("The video is being made; time left: about 2 min."))
      << "a quarter took 30 s, so that 90 s are left";
  EXPECT_THAT(school->get(address, anna).body, HasSubstr("Show the progress of the video"));
  succeed(queue.storeResult(school->annas, "The case is not here."));
  EXPECT_EQ(headerOf(school->get(address + "/video", anna), "Location"), address + "#video");
  EXPECT_THAT(school->get(address, anna).body, HasSubstr("The case is not here."));
  EXPECT_THAT(school->get(address, anna).body, HasSubstr("Make video")) << "it can be tried again";
}

TEST_P(WebVideo, ThePageSaysThatTheServerGaveUp) {
  std::ofstream(recording()) << "a recording";
  const std::string anna = school->signIn("anna");
  EXPECT_EQ(school->post(address + "/video", {}, anna).status, 303);
  for (const char* server : {"first", "second", "third", "fourth"}) {
    (void)valueOf(VideoQueue(school->store, server).takeNext());
    rig->pass(130 * kSecond_us);
  }
  EXPECT_THAT(school->get(address, anna).body, HasSubstr("the server stopped three times while it made this video"));
}

TEST_P(WebVideo, ThePageShowsTheVideoWithItsEventsAndComments) {
  std::ofstream(recording()) << "a recording";
  putVideo();
  valueOf(CommentStore(school->as(school->ina)).add(school->annas, 1'800'000, "Hold still."));
  const web::Response page = school->get(address, school->signIn("anna"));
  EXPECT_THAT(page.body, HasSubstr("<video controls"));
  EXPECT_THAT(page.body, HasSubstr("src=\"" + address + "/video.webm\""));
  const std::size_t first = page.body.find("href=\"" + address + "/video.webm#t=1.50\" data-time=\"1.50\"");
  ASSERT_NE(first, std::string::npos);
  EXPECT_THAT(page.body, HasSubstr("The skin &lt;was&gt; punctured."));
  EXPECT_THAT(page.body, HasSubstr("Critical error: </span>The artery was punctured."));
  EXPECT_THAT(page.body, HasSubstr("Comment by Dr ina: </span>Hold still."));
  const std::size_t list = page.body.find("<ol class=\"moments\"");
  EXPECT_LT(page.body.find("The skin", list), page.body.find("Hold still.", list));
  EXPECT_LT(page.body.find("Hold still.", list), page.body.find("The artery", list));
  EXPECT_THAT(headerOf(page, "Content-Security-Policy"), HasSubstr("script-src 'self'"));
  EXPECT_THAT(headerOf(page, "Content-Security-Policy"), Not(HasSubstr("unsafe")));
  EXPECT_THAT(headerOf(school->get("/me", school->signIn("anna")), "Content-Security-Policy"),
              Not(HasSubstr("media-src")))
      << "only the page with a video needs media";
  EXPECT_THAT(school->get("/video.js").body, HasSubstr("currentTime"));
}

TEST_P(WebVideo, TheVideoIsSentToThoseWhoMaySeeTheAttempt) {
  putVideo();
  const std::string file = address + "/video.webm";
  for (const auto& [who, status] : std::map<std::string, int>{
           {"anna", 200}, {"ben", 404}, {"carl", 404}, {"ina", 200}, {"otto", 404}, {"admin", 200}}) {
    const web::Response sent = school->get(file, school->signIn(who));
    EXPECT_EQ(sent.status, status) << who;
    EXPECT_EQ(sent.file.empty(), status != 200) << who;
  }
  EXPECT_EQ(school->get(file).status, 303) << "sign in first";
  web::Request part = WebSchool::request("GET", file, school->signIn("anna"));
  part.headers["range"] = "bytes=2-4";
  const web::Response sent = school->site.answer(part);
  EXPECT_EQ(sent.status, 206);
  EXPECT_EQ(sent.type, "video/webm");
  EXPECT_EQ(sent.fileBegin, 2U);
  EXPECT_EQ(sent.fileSize, 3U);
  EXPECT_EQ(headerOf(sent, "Content-Range"), "bytes 2-4/10");
}

TEST_P(WebVideo, OneEntryAnHourStandsForAllPartsOfAVideoThatAUserWatches) {
  putVideo();
  const auto entriesOf = [&](const Person& user, bool allowed) {
    const auto entries = valueOf(AuditLog(school->admin).page(1000));
    return std::ranges::count_if(entries, [&](const AuditEntry& entry) {
      return entry.actor == user.id && entry.act == "see attempts" && entry.allowed == allowed;
    });
  };
  const std::string ina = school->signIn("ina"), file = address + "/video.webm";
  const auto watch = [&](const std::string& secret) {
    for (int i = 0; i < 5; ++i) {
      web::Request part = WebSchool::request("GET", file, secret);
      part.headers["range"] = "bytes=" + std::to_string(i) + "-" + std::to_string(i);
      (void)school->site.answer(part);
      (void)school->get(address + "/video", secret);
      rig->pass(60 * kSecond_us);
    }
  };
  watch(ina);
  EXPECT_EQ(entriesOf(school->ina, true), 1);
  EXPECT_TRUE(std::ranges::any_of(valueOf(AuditLog(school->admin).page(1000)), [&](const AuditEntry& entry) {
    return entry.actor == school->ina.id && entry.detail == "video, attempt " + school->annas;
  }));
  rig->pass(3600 * kSecond_us);
  watch(school->signIn("ina"));
  EXPECT_EQ(entriesOf(school->ina, true), 2) << "an hour later";
  (void)school->get(address, school->signIn("ina"));
  EXPECT_GT(entriesOf(school->ina, true), 2) << "each look at the page has an entry";
  watch(school->signIn("otto"));
  EXPECT_EQ(entriesOf(school->otto, false), 10) << "each refusal";
}

TEST_P(WebVideo, OneEntryStandsForOneAttemptOnly) {
  putVideo();
  const std::string other = keepAttempt(school->as(school->anna)).id;
  const AttemptVideos videos(school->as(school->ina));
  const auto entries = [&] { return valueOf(AuditLog(school->admin).page(1000, 0, school->anna.id)).size(); };
  const std::size_t before = entries();
  (void)valueOf(videos.state(school->annas));
  (void)valueOf(videos.state(other));
  EXPECT_EQ(entries(), before + 2 + 1) << "the other look is that at the log";
  (void)valueOf(videos.state(school->annas));
  EXPECT_EQ(entries(), before + 3 + 1);
}

TEST_P(WebVideo, TheServerMakesWhatWasAskedFor) {
  putRecording();
  fs::create_directories(options.cases);
  ASSERT_TRUE(writeCase(smallAttemptCase(), options.cases / "block"));
  succeed(AttemptVideos(school->as(school->anna)).request(school->annas));
  const web::VideoFiles files(options.videos);
  {
    const web::VideoMaker maker(school->store, options);
    for (int i = 0; i < 600 && valueOf(VideoQueue(school->store, "").waiting()) > 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_EQ(valueOf(AttemptVideos(school->as(school->anna)).state(school->annas)).why, "");
  ASSERT_TRUE(files.has(school->annas));
  std::ifstream in(files.video(school->annas), std::ios::binary);
  EXPECT_EQ(in.get(), 0x1A) << "the beginning of a WebM file";
  const auto moments = files.moments(school->annas);
  ASSERT_FALSE(moments.empty());
  EXPECT_THAT(school->get(address, school->signIn("anna")).body, HasSubstr(moments.front().description));
  const auto path = files.path(school->annas);
  ASSERT_TRUE(path);
  ASSERT_FALSE(path->pieces.empty());
  EXPECT_LT(path->pieces.front().points.front().tip_probe.z, path->pieces.back().points.back().tip_probe.z)
      << "the needle was advanced";
  EXPECT_TRUE(std::ranges::count(path->structures.labels, kVein) > 0) << "and leads to the vein";
}

TEST_P(WebVideo, NoVideoStaysOfAPersonWhoWasErasedWhileItWasMade) {
  putRecording();
  fs::create_directories(options.cases);
  ASSERT_TRUE(writeCase(smallAttemptCase(), options.cases / "block"));
  succeed(AttemptVideos(school->as(school->anna)).request(school->annas));
  const web::VideoFiles files(options.videos);
  {
    const web::VideoMaker maker(school->store, options);
    const auto isMaking = [&] {
      return valueOf(AttemptVideos(school->admin).state(school->annas)).stage == VideoState::Stage::Making;
    };
    for (int i = 0; i < 1000 && !isMaking(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    succeed(PersonData(school->admin).erase(school->anna.id));
    // The maker takes the next request when it has ended this one.
    succeed(AttemptVideos(school->admin).request(keepAttempt(school->as(school->ben)).id));
    for (int i = 0; i < 600 && valueOf(VideoQueue(school->store, "").waiting()) > 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_FALSE(files.has(school->annas));
  EXPECT_TRUE(files.moments(school->annas).empty());
}

TEST_P(WebVideo, ARecordingThatCannotBeReadForAWhileKeepsItsVideo) {
  putVideo();
  succeed(AttemptVideos(school->as(school->anna)).request(school->annas));
  fs::create_symlink(recording(), recording());
  {
    const web::VideoMaker maker(school->store, options);
    for (int i = 0; i < 300 && valueOf(VideoQueue(school->store, "").waiting()) > 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  EXPECT_NE(valueOf(AttemptVideos(school->as(school->anna)).state(school->annas)).why, "");
  EXPECT_TRUE(web::VideoFiles(options.videos).has(school->annas));
}

TEST_P(WebVideo, AVideoThatCannotBeMadeHasAReasonWithoutPaths) {
  succeed(AttemptVideos(school->as(school->anna)).request(school->annas));
  std::ofstream(recording()) << "no recording";
  {
    const web::VideoMaker maker(school->store, options);
    for (int i = 0; i < 300 && valueOf(VideoQueue(school->store, "").waiting()) > 0; ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  const std::string why = valueOf(AttemptVideos(school->as(school->anna)).state(school->annas)).why;
  EXPECT_THAT(why, HasSubstr("The recording"));
  EXPECT_THAT(why, Not(HasSubstr(rig->services.recordings.string())));
  EXPECT_FALSE(web::VideoFiles(options.videos).has(school->annas));
}

TEST(WebVideoFiles, KeepsWhatWasWatchedLast) {
  const TemporaryFolder folder;
  const web::VideoFiles files(folder / "videos");
  for (const std::string name : {"a", "b", "c", "d"}) {
    ASSERT_TRUE(files.keepMoments(name, {}));
    std::ofstream(files.video(name)) << std::string(1000, 'x');
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  files.use("a");
  files.trim(3000, "d");
  EXPECT_TRUE(files.has("a")) << "it was watched since";
  EXPECT_FALSE(files.has("b"));
  EXPECT_TRUE(files.has("c"));
  files.trim(10, "d");
  EXPECT_FALSE(files.has("a"));
  EXPECT_TRUE(files.has("d")) << "the newest stays, whatever its size";
  EXPECT_FALSE(fs::exists(folder / "videos" / "a.json"));
}

}  // namespace
}  // namespace insonate::test
