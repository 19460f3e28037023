#include "CurriculumCommands.h"
#include "support/SmallCase.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/site/CaseDownload.h>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iterator>
#include <stdexcept>

namespace insonate::test {
namespace {

using testing::HasSubstr;
using namespace std::chrono_literals;

/// The program insonate-server, at a free port of this computer.
class ServerProcess {
 public:
  ServerProcess(const std::string& database, const std::string& log, const std::string& cases)
      : log_(log), process_(::fork()) {
    if (process_ != 0) return;
    if (!std::freopen(log.c_str(), "w", stdout) || !std::freopen("/dev/null", "w", stderr)) ::_exit(1);
    ::execl(INSONATE_SERVER, INSONATE_SERVER, database.c_str(), "--listen", "127.0.0.1:0", "--cases", cases.c_str(),
            nullptr);
    ::_exit(1);
  }
  ~ServerProcess() {
    ::kill(process_, SIGTERM);
    ::waitpid(process_, nullptr, 0);
  }
  ServerProcess(const ServerProcess&) = delete;
  ServerProcess& operator=(const ServerProcess&) = delete;

  std::string url() const {
    for (int i = 0; i < 100; ++i) {
      std::ifstream log(log_);
      for (std::string word; log >> word;)
        if (word.starts_with("http://")) return word;
      std::this_thread::sleep_for(100ms);
    }
    throw std::runtime_error("the server did not start");
  }

 private:
  std::string log_;
  pid_t process_;
};

/// A class on a server, and a workstation with a database of its own.
class CurriculumSite : public CurriculumCommands {
 protected:
  void SetUp() override {
    makeClass();
    serverDatabase = database;
    const auto store = CurriculumStore::open(serverDatabase);
    if (!store) throw std::runtime_error(store.error().message);
    told("workstations add " + shellWord(store->workstation()) + " --token-file " + path("token") + " --as boss");
    server.emplace(serverDatabase, folder / "server.log", folder / "cases");
    url = server->url();
    database = folder / "workstation.sqlite";
  }
  std::string upload(const std::string& more = "") const {
    return "upload " + shellWord(url) + " --token-file " + path("token") + " " + more;
  }
  /// A recording that the workstation has sealed for a new attempt of alice at the first level.
  std::string recordSealed(double seconds) const {
    const auto store = CurriculumStore::open(database);
    const auto alice = store ? store->signIn("alice", kPassword) : tl::unexpected(store.error());
    if (!alice) throw std::runtime_error(alice.error().message);
    AttemptFacts facts{.id = "1c2f8f6e-6a5e-4b52-9c3e-6a1c55d1e0aa",
                       .person = alice->person().id,
                       .curriculum = "two",
                       .curriculumVersion = 1,
                       .level = "first"};
    const auto seal = AttemptStore(*alice).issueSeal(facts);
    if (!seal) throw std::runtime_error(seal.error().message);
    return record("sealed", Ending::InVein, seconds, utc(0), {facts.id, facts.person, "two", 1, "first", seal->nonce},
                  seal->key);
  }
  /// The proof of alice's only attempt, once the server has verified it.
  std::string proofOnServer() const {
    CurriculumSite* self = const_cast<CurriculumSite*>(this);
    const std::string here = std::exchange(self->database, serverDatabase);
    std::string proof;
    for (int i = 0; i < 100 && (proof.empty() || proof == "being verified"); ++i) {
      const json attempts = told("attempts list alice --as miller")["attempts"];
      proof = attempts.size() == 1 ? attempts[0]["proof"].get<std::string>() : "none";
      std::this_thread::sleep_for(100ms);
    }
    self->database = here;
    return proof;
  }

  static std::string fileText(const std::string& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::string serverDatabase, url;
  std::optional<ServerProcess> server;
};

TEST_F(CurriculumSite, AnAttemptAtAWorkstationIsVerifiedByTheServer) {
  EXPECT_GE(told(upload("--as alice"))["pending"], 0);
  told("attempts add " + recordSealed(1) + " --as alice");
  const json sent = told(upload());
  EXPECT_EQ(sent["attempts"], 1);
  EXPECT_EQ(sent["recordings"], 1);
  EXPECT_EQ(proofOnServer(), "proven");
  database = serverDatabase;
  EXPECT_EQ(told("levels alice --as miller")["paths"][0]["levels"][0]["state"], "mastered");
  EXPECT_EQ(run("verify --as boss").status, 0) << "with the recordings that the server keeps";
}

TEST_F(CurriculumSite, ARecordingThatTheWorkstationDidNotSealIsNotProven) {
  told(upload("--as alice"));
  told("attempts add " + record("unsealed", Ending::InVein, 1) + " --level first --as alice");
  told(upload());
  EXPECT_EQ(proofOnServer(), "not proven");
}

TEST_F(CurriculumSite, AWorkstationReceivesThePublishedCaseOfItsClass) {
  PatientCase neck = smallCase();
  neck.manifest.title = "Broad neck";
  const std::filesystem::path home = folder / "cases/broad";
  std::filesystem::create_directories(home.parent_path());
  ASSERT_TRUE(saveCaseVersion(neck, home, "2026-11-22", ""));
  ASSERT_TRUE(publishCase(neck, home, "2026-11-22"));
  std::string curriculum = fileText(folder / "two.json");
  const auto replace = [&](const std::string& from, const std::string& to) {
    curriculum.replace(curriculum.find(from), from.size(), to);
  };
  replace("textbook", "Broad neck"), replace(R"("version": 1)", R"("version": 2)");
  std::ofstream(folder / "broad.json") << curriculum;
  const std::string here = std::exchange(database, serverDatabase);
  EXPECT_THAT(refused("check " + path("broad.json")), HasSubstr("Broad neck"));
  EXPECT_EQ(run("check " + path("broad.json") + " --cases " + path("cases")).status, 0);
  told("publish " + path("broad.json") + " --cases " + path("cases") + " --as boss");
  told("classes curriculum 'Year 1' two --as boss");
  database = here;
  const json sent = told(upload("--as alice --cases " + path("downloads")));
  EXPECT_EQ(sent["cases"], json({"Broad neck"}));
  const auto place = downloadStateOf(folder / "downloads", "Broad neck").place;
  ASSERT_TRUE(place);
  EXPECT_EQ(voxelHashOf(readCase(*place)->patient), voxelHashOf(neck));
  EXPECT_EQ(told(upload("--cases " + path("downloads")))["cases"], json::array());
  EXPECT_THAT(refused("upload " + shellWord(serverDatabase) + " --cases " + path("downloads")), HasSubstr("--cases"));
}

TEST_F(CurriculumSite, WithoutAccessNothingIsExchanged) {
  EXPECT_THAT(refused("attempts add " + record("early", Ending::InVein, 1) + " --level first --as alice"),
              HasSubstr("There is no store"))
      << "nobody has signed in here";
  EXPECT_THAT(refused(upload("--as alice"), "a wrong password"), HasSubstr("password"));
  std::ofstream(folder / "token") << std::string(64, '0') << '\n';
  EXPECT_THAT(refused(upload()), HasSubstr("does not accept this computer's token"));
  EXPECT_THAT(refused("upload http://example.org --token-file " + path("token")), HasSubstr("unencrypted"));
}

}  // namespace
}  // namespace insonate::test
