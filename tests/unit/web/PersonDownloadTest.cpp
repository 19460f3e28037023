#include "WebRig.h"
#include "support/ZipContent.h"

#include <insonate/curriculum/AuditLog.h>

#include <fstream>
#include <map>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

class WebPersonDownload : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    rig->services.recordings = rig->folder / "recordings";
    fs::create_directories(rig->services.recordings);
    school.emplace(rig->open());
    std::ofstream(rig->services.recordings / (school->annas + ".attempt")) << "motion";
  }
  std::string annasData() const { return "/people/" + school->anna.id + "/data"; }

  std::optional<WebSchool> school;
};
INSONATE_ON_BOTH(WebPersonDownload);

TEST_P(WebPersonDownload, SendsAFileThatExistsOnlyWhileItIsSent) {
  fs::path file;
  {
    const web::Response response = school->post("/me/data", {}, school->signIn("anna"));
    EXPECT_EQ(response.status, 200);
    EXPECT_EQ(response.type, "application/zip");
    EXPECT_EQ(headerOf(response, "Content-Disposition"), "attachment; filename=\"personal-data.zip\"");
    EXPECT_EQ(headerOf(response, "Cache-Control"), "no-store");
    file = response.file;
    EXPECT_EQ(response.fileSize, fs::file_size(file));
    EXPECT_EQ(fs::status(file.parent_path()).permissions(), fs::perms::owner_all);
    const auto content = zipContent(file);
    EXPECT_EQ(content.at("recordings/" + school->annas + ".attempt"), "motion");
    EXPECT_THAT(content.at("person.json"), HasSubstr("anna@example.org"));
  }
  EXPECT_FALSE(fs::exists(file));
}

TEST_P(WebPersonDownload, IsForThePersonAndAdministratorsAlone) {
  for (const auto& [who, status] : std::map<std::string, int>{
           {"anna", 200}, {"admin", 200}, {"ben", 403}, {"carl", 403}, {"ina", 403}, {"otto", 403}}) {
    const web::Response response = school->post(annasData(), {}, school->signIn(who));
    EXPECT_EQ(response.status, status) << who;
    EXPECT_EQ(response.file.empty(), status != 200) << who;
  }
  EXPECT_EQ(school->post(annasData(), {}).status, 403) << "nobody is signed in";
  EXPECT_EQ(school->get("/me/data", school->signIn("anna")).status, 405) << "a link of another page starts no export";
  web::Request forged = WebSchool::request("POST", "/me/data", school->signIn("anna"));
  EXPECT_EQ(school->site.answer(forged).status, 403) << "without the code of the session";
  EXPECT_EQ(school->post("/people/' OR 1=1 --/data", {}, school->signIn("admin")).status, 403);
}

TEST_P(WebPersonDownload, PagesOfferItToThoseWhoMay) {
  const std::string account = "/people/" + school->anna.id;
  EXPECT_THAT(school->get("/me", school->signIn("anna")).body, HasSubstr("Download my data"));
  EXPECT_THAT(school->get(account, school->signIn("anna")).body, HasSubstr("Download my data"));
  EXPECT_THAT(school->get(account, school->signIn("admin")).body, HasSubstr("action=\"" + account + "/data\""));
  EXPECT_THAT(school->get(account, school->signIn("ina")).body, Not(HasSubstr("Download")));
  EXPECT_THAT(school->get("/classes/" + school->spring.id + account, school->signIn("ina")).body,
              Not(HasSubstr("Download my data")));
}

TEST_P(WebPersonDownload, AFullDiskIsToldWithoutThePathsOfTheServer) {
  std::ofstream(rig->folder / "downloads") << "a file where the folder should be";
  const web::Response response = school->post("/me/data", {}, school->signIn("anna"));
  EXPECT_EQ(response.status, 503);
  EXPECT_THAT(response.body, AllOf(HasSubstr("could not write the file"), Not(HasSubstr(rig->folder.path().string()))));
}

TEST_P(WebPersonDownload, APersonHasOneAtATimeAndAServerThree) {
  const std::string anna = school->signIn("anna"), admin = school->signIn("admin");
  const auto dataOf = [](const Person& person) { return "/people/" + person.id + "/data"; };
  {
    const web::Response first = school->post("/me/data", {}, anna);
    EXPECT_EQ(first.status, 200);
    const web::Response second = school->post("/me/data", {}, anna);
    EXPECT_EQ(second.status, 429);
    EXPECT_THAT(second.body, HasSubstr("are being downloaded already"));
    EXPECT_TRUE(fs::exists(first.file));
    const web::Response ben = school->post(dataOf(school->ben), {}, admin),
                        carl = school->post(dataOf(school->carl), {}, admin);
    EXPECT_EQ(ben.status, 200);
    EXPECT_EQ(carl.status, 200);
    EXPECT_EQ(school->post(dataOf(school->ina), {}, admin).status, 429) << "three others go on";
  }
  EXPECT_EQ(school->post("/me/data", {}, anna).status, 200) << "the others have ended";
}

TEST_P(WebPersonDownload, FilesOfAServerThatWasKilledAreRemovedAfterADay) {
  const fs::path folder = rig->folder / "downloads";
  fs::create_directories(folder);
  for (const char* name : {"old.zip", "new.zip"}) std::ofstream(folder / name) << "x";
  fs::last_write_time(folder / "old.zip", fs::file_time_type::clock::now() - std::chrono::hours(25));
  (void)school->post("/me/data", {}, school->signIn("anna"));
  EXPECT_FALSE(fs::exists(folder / "old.zip"));
  EXPECT_TRUE(fs::exists(folder / "new.zip")) << "another server may be sending it";
}

}  // namespace
}  // namespace insonate::test
