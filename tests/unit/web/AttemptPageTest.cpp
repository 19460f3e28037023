#include "WebRig.h"
#include "attempt/PathSection.h"
#include "http/EventStream.h"
#include "video/PathText.h"
#include "video/VideoFiles.h"

#include <insonate/curriculum/Implausible.h>
#include <insonate/curriculum/SiteService.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/VerificationQueue.h>
#include <insonate/curriculum/Workstations.h>
#include <insonate/teaching/MetricCatalog.h>
#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

#include <QtCore/QCryptographicHash>
#include <algorithm>
#include <array>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// In through the vein, and behind it outside of the slice.
NeedlePath pathThroughTheVein() {
  NeedlePath path{
      .time_us = 1'500'000, .area = {-15, 15, -5, 25}, .pieces = {}, .pixel_mm = 10, .structures = {3, 3, {}}};
  path.structures.labels = {kSkin, kSkin, kSkin, 0, kVein, kArtery, 0, 0, kArtery};
  path.pieces = {{NeedlePlace::UnderSkin, true, {{1'000'000, {0, 0, 2}}, {1'400'000, {1, 0.5, 12}}}},
                 {NeedlePlace::Vein, true, {{1'400'000, {1, 0.5, 12}}, {1'500'000, {1.25, 0.5, 14}}}},
                 {NeedlePlace::WrongPlace, false, {{1'500'000, {1.25, 0.5, 14}}, {1'600'000, {2, 6, 20.5}}}}};
  return path;
}

TEST(WebNeedlePath, APathIsStoredAndReadAgain) {
  const NeedlePath path = pathThroughTheVein();
  EXPECT_EQ(web::pathFromJson(web::pathToJson(path)), path);
  nlohmann::json damaged = web::pathToJson(path);
  damaged["columns"] = 1000;
  EXPECT_TRUE(web::pathFromJson(damaged)->structures.labels.empty()) << "there are fewer labels";
  damaged["pieces"] = "none";
  EXPECT_EQ(web::pathFromJson(damaged), std::nullopt);
}

TEST(WebNeedlePath, TheTableHasTheNumbersOfTheDrawing) {
  const std::string html = web::drawPath(pathThroughTheVein()).html();
  for (const char* part :
       {"class=\"path inserted\"", "class=\"path in-vein\"", "class=\"path wrong-place beside\"", "\u25b2</text>",
        "class=\"structure vein\"", "class=\"structure artery\"", ">vein</text>", "at 0:01.5</figcaption>",
        "<td>14</td>", "<td>20.5</td>", "<td>wrong place</td><td>no</td><td>2</td>"})
    EXPECT_THAT(html, HasSubstr(part));
  EXPECT_THAT(html, Not(HasSubstr("class=\"structure bone\""))) << "the section has no bone";
  EXPECT_THAT(web::drawPath({}).html(), AllOf(HasSubstr("No path to show"), Not(HasSubstr("<svg"))));
}

class WebAttemptPage : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    rig->services.recordings = rig->folder / "recordings";
    std::filesystem::create_directories(rig->services.recordings);
    options.videos = rig->folder / "videos";
    school.emplace(rig->open(), options);
    address = "/attempts/" + school->annas;
  }
  web::WebOptions options;
  std::optional<WebSchool> school;
  std::string address;
};
INSONATE_ON_BOTH(WebAttemptPage);

TEST_P(WebAttemptPage, ThePathComesWithTheVideo) {
  const std::string ina = school->signIn("ina");
  EXPECT_THAT(school->get(address, ina).body, Not(HasSubstr("Path of the needle")));
  std::ofstream(rig->services.recordings / (school->annas + ".attempt")) << "a recording";
  EXPECT_THAT(school->get(address, ina).body, HasSubstr("also shows the path of the needle"));
  const web::VideoFiles files(options.videos);
  ASSERT_TRUE(files.keepMoments(school->annas, {}, pathThroughTheVein()));
  std::ofstream(files.video(school->annas)) << "0123456789";
  EXPECT_EQ(files.path(school->annas), pathThroughTheVein());
  EXPECT_THAT(school->get(address, ina).body,
              AllOf(HasSubstr("<h2>Path of the needle</h2>"), HasSubstr("class=\"path in-vein\"")));
  EXPECT_EQ(school->get(address, school->signIn("otto")).status, 404) << "an instructor of another class";
  ASSERT_TRUE(files.remove(school->annas));
  EXPECT_EQ(files.path(school->annas), std::nullopt) << "the path of an erased person is deleted with the video";
}

TEST_P(WebAttemptPage, MetricsHavePublishedValuesDefinitionAndSource) {
  const auto& all = MetricCatalog::instance().all();
  const auto meaning = std::ranges::find(all, std::string("needle_path_mm"), &MetricMeaning::id);
  const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
  const Level& level = curriculum.levels.front();
  AttemptFacts facts = begunFacts();
  facts.curriculumVersion = curriculum.version, facts.level = level.name, facts.procedure = level.procedure;
  facts = endedFacts(facts);
  facts.metrics = {{meaning->id, meaning->version, 50.0}};
  valueOf(AttemptStore(school->as(school->anna)).begin(facts));
  succeed(AttemptStore(school->as(school->anna)).end(facts));
  const std::string page = school->get("/attempts/" + facts.id, school->signIn("anna")).body;
  const MetricMeaning& known = MetricCatalog::instance().withNormsOf(level.procedure, *meaning);
  ASSERT_TRUE(known.novice && known.expert);
  EXPECT_THAT(page, HasSubstr("<th scope=\"row\">" + meaning->title + "</th><td>50 mm</td><td>" +
                              publishedValue(*known.novice, meaning->unit) + "</td><td>" +
                              publishedValue(*known.expert, meaning->unit) + "</td>"));
  for (const MetricExplanation& part : MetricCatalog::instance().explanationOf(level.procedure, *meaning))
    EXPECT_THAT(page, HasSubstr(part.heading + ": </span>" + web::text(part.text).html()));
}

TEST_P(WebAttemptPage, ValuesThatOccurredBeforeAreFlaggedForInstructors) {
  const SignedIn ben = school->as(school->ben);
  AttemptFacts facts = begunFacts();
  facts.curriculumVersion = valueOf(loadCurriculum("central_line")).version;
  facts.level = valueOf(loadCurriculum("central_line")).levels.front().name;
  const std::vector<MetricFact> metrics{{"vein_punctures", 1, 1.0}, {"passes", 1, 1.0}, {"needle_path_mm", 1, 41.25}};
  for (AttemptFacts one : {facts, facts}) {
    one.id = freshUuid();
    one = endedFacts(one);
    one.metrics = metrics, one.recordingHash.clear(), one.recording.clear();
    valueOf(AttemptStore(ben).begin(one));
    succeed(AttemptStore(ben).end(one));
    facts.id = one.id;
  }
  const std::string words = displayText(Implausible::SameValues, facts);
  EXPECT_THAT(school->get("/attempts/" + facts.id, school->signIn("ina")).body, HasSubstr(words));
  EXPECT_THAT(school->get("/attempts/" + facts.id, school->signIn("ben")).body, Not(HasSubstr(words)));
}

/// Returns the text that a browser has received from a stream; waits half a minute at most for `part`.
bool receives(web::EventStream& stream, const std::string& part) {
  for (int i = 0; i < 300; ++i) {
    std::array<char, 4096> text{};
    // Without a connection nothing can be suspended, so that the stream must not be read when it is empty.
    stream.push("probe", 0);
    const auto count = stream.read(nullptr, text.data(), text.size(), -1);
    if (count > 0 && std::string(text.data(), std::size_t(count)).find(part) != std::string::npos) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  return false;
}

/// Sends an attempt of Anna from a workstation. Returns its id.
std::string sentAttempt(const StoreRig& rig, const WebSchool& school) {
  StoreRig ward;
  ward.services.now_us = [&rig] { return rig.now_us; };
  const CurriculumStore near = ward.open();
  const std::string token = valueOf(Workstations(school.admin).add("ward 7"));
  const SiteLink link{.place = "https://site.example.org",
                      .send = [&](const std::string& path, const std::string& body) -> Result<SiteAnswer> {
                        const SiteService service(school.store);
                        const auto answer = service.answer(*valueOf(service.workstationOf(token)), path, body);
                        return answer ? SiteAnswer{false, *answer} : SiteAnswer{true, answer.error().message};
                      }};
  SiteUpload site(near, link);
  EXPECT_EQ(valueOf(site.signIn("anna", kPassword)), SiteUpload::Reached::Yes);
  const std::string content(2000, 'a');
  const std::filesystem::path file = ward.folder / "recording";
  std::ofstream(file) << content;
  AttemptFacts facts = endedFacts(begunFacts());
  const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
  facts.curriculumVersion = curriculum.version, facts.level = curriculum.levels.front().name;
  facts.begun_us = rig.now_us;
  facts.recordingHash =
      QCryptographicHash::hash(QByteArray::fromStdString(content), QCryptographicHash::Sha256).toHex().toStdString();
  valueOf(AttemptStore(valueOf(near.signIn("anna", kPassword))).add(facts, file));
  EXPECT_THAT(valueOf(site.exchange()).errors, ::testing::IsEmpty());
  return facts.id;
}

TEST_P(WebAttemptPage, APageOfAnAttemptThatIsBeingVerifiedIsToldOfTheResult) {
  rig->pass(kSecond_us);
  const std::string attempt = sentAttempt(*rig, *school), page = "/attempts/" + attempt, ina = school->signIn("ina");
  const std::string before = school->get(page, ina).body, attribute = "data-events=\"";
  EXPECT_THAT(before, AllOf(HasSubstr("being verified"), HasSubstr(attribute + page + "/events?since=")));
  const std::size_t from = before.find(attribute) + attribute.size();
  const std::string events = before.substr(from, before.find('"', from) - from);
  EXPECT_EQ(school->get(events, school->signIn("otto")).status, 404) << "an instructor of another class";
  const auto stream = school->get(events, ina).events;
  ASSERT_TRUE(stream);

  const VerificationQueue queue(school->store);
  ASSERT_TRUE(valueOf(queue.takeNext()));
  succeed(queue.storeResult(attempt, true, ""));
  EXPECT_TRUE(receives(*stream, "event: changed"));
  const std::string after = school->get(page, ina).body;
  EXPECT_THAT(after, AllOf(HasSubstr("proven<span"), Not(HasSubstr(attribute)))) << "nothing is left to wait for";
}

}  // namespace
}  // namespace insonate::test
