#include "integration/CommandLine.h"
#include "support/TestData.h"

#include <insonate/simulator/ImageFiles.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <random>
#include <set>
#include <string>

namespace insonate::test {
namespace {

using testing::HasSubstr;

TEST(BenchCommand, RefusesFoldersThatCannotBeBeforeAnyWork) {
  const TemporaryFolder folder;
  const std::string errors = folder / "errors.txt";
  const std::string missing = folder.path() / "none" / "bench";
  const CommandResult noParent = runCommand("bench ultrasound --json --out " + shellWord(missing), errors);
  EXPECT_EQ(noParent.status, 1);
  EXPECT_THAT(noParent.errors, HasSubstr("does not exist"));
  EXPECT_THAT(noParent.output, HasSubstr("\"error\": "));
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));

  std::ofstream(folder / "file") << "text";
  const CommandResult aFile = runCommand("bench ultrasound --out " + shellWord(folder / "file"), errors);
  EXPECT_EQ(aFile.status, 1);
  EXPECT_THAT(aFile.errors, HasSubstr("is a file"));
  EXPECT_EQ(runCommand("bench deformation --out " + shellWord(folder / "file"), errors).status, 1);
}

TEST(BenchCommand, WrongUsage) {
  const TemporaryFolder folder;
  const std::string errors = folder / "errors.txt";
  EXPECT_EQ(runCommand("bench", errors).status, 2);
  EXPECT_EQ(runCommand("bench ultrasound", errors).status, 2);
  EXPECT_EQ(runCommand("bench ultrasound --out x --fast", errors).status, 2);
}

/// Speckle-like gray, brighter near the top.
void writeStill(const std::filesystem::path& file, unsigned seed) {
  BModeImage image;
  image.width = 300, image.height = 260, image.pixel_mm = 0.1;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      image.gray.push_back(std::uint8_t(std::clamp(90 - 0.2 * y + 20 * normal(random), 0.0, 255.0)));
  const auto written = writePng(image, file);
  ASSERT_TRUE(written) << written.error().message;
}

TEST(BenchCommand, RealismNamesFaultsOfListAndOptions) {
  const TemporaryFolder folder;
  const std::string errors = folder / "errors.txt", out = " --out " + shellWord(folder / "out");
  writeStill(folder / "a.png", 1);
  std::ofstream(folder / "list.csv") << "a.png,10,machine,probe=round\n";
  const std::string list = "bench realism --real " + shellWord(folder / "list.csv") + out;
  const CommandResult badList = runCommand(list, errors);
  EXPECT_EQ(badList.status, 1);
  EXPECT_THAT(badList.errors, HasSubstr("Line 1"));
  EXPECT_THAT(badList.errors, HasSubstr("linear, curvilinear or phased, not \"round\""));
  std::ofstream(folder / "list.csv") << "a.png,10,machine\n";
  const CommandResult badProbe = runCommand(list + " --probe square", errors);
  EXPECT_EQ(badProbe.status, 1);
  EXPECT_THAT(badProbe.errors, HasSubstr("not \"square\""));
  EXPECT_EQ(runCommand(list + " --plane sagittal", errors).status, 2);
  EXPECT_EQ(runCommand("bench realism --point-spread --clips" + out, errors).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

TEST(BenchCommand, RealismGoesFromAListToAScore) {
  const TemporaryFolder folder;
  const std::string errors = folder / "errors.txt", out = " --out " + shellWord(folder / "out");
  writeStill(folder / "a.png", 1), writeStill(folder / "b.png", 2);
  std::ofstream(folder / "list.csv") << "a.png,10,machine A\nb.png,10,machine B,plane=longitudinal\n";
  const CommandResult made =
      runCommand("bench realism --count 2 --json --real " + shellWord(folder / "list.csv") + out, errors);
  ASSERT_EQ(made.status, 0) << made.errors;
  EXPECT_THAT(made.output, HasSubstr("\"probe\": \"linear\""));
  for (const char* file : {"out/index.html", "out/features.csv", "out/blind/sheet.html", "out/blind/004.jpg"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
  EXPECT_FALSE(std::filesystem::exists(folder / "out/unmatched"));
  std::ifstream key(folder / "out/key.csv");
  std::string line;
  std::getline(key, line);
  std::ofstream ratings(folder / "ratings.csv");
  for (int number = 1; std::getline(key, line); ++number)
    ratings << number << (line.starts_with(std::to_string(number) + ",1,") ? ",6\n" : ",1\n");
  ratings.close();
  const CommandResult scored = runCommand("bench realism --ratings " + shellWord(folder / "ratings.csv") + out, errors);
  ASSERT_EQ(scored.status, 0) << scored.errors;
  EXPECT_THAT(scored.output, HasSubstr("4 images, 1 readers: sensitivity 1.00, specificity 1.00, ROC area 1.00"));
}

TEST(BenchCommand, AServerUnderLoadThatIsKilledLosesNothing) {
  const TemporaryFolder folder;
  const CommandResult run = runCommand(
      "bench server --workstations 3 --trainees 4 --minutes 0.15 --recording 0.1 --readers 2 --live 2 --kills 2 --json "
      "--out " +
          shellWord(folder / "out"),
      folder / "errors.txt");
  ASSERT_EQ(run.status, 0) << run.errors;
  const auto results = nlohmann::json::parse(run.output);
  EXPECT_EQ(results["acknowledged"], 3);
  EXPECT_EQ(results["trainees"], 4);
  EXPECT_EQ(results["lost"], 0);
  EXPECT_EQ(results["verified"], 3) << "the server computes what the workstations computed";
  EXPECT_EQ(results["kills"], 2);
  EXPECT_GT(results["processor_s"], 0.0);
  EXPECT_NEAR(results["recordings_MB"].get<double>(), 0.3, 0.15);
  std::set<std::string> requests;
  for (const auto& row : results["rows"]) {
    requests.insert(row["request"].get<std::string>());
    EXPECT_LE(row["p50_ms"].get<double>(), row["p95_ms"].get<double>()) << row;
  }
  EXPECT_THAT(requests, testing::IsSupersetOf({"workstation sends an attempt", "page opened"}));
  EXPECT_TRUE(std::filesystem::exists(folder / "out" / "server.md"));
}

TEST(BenchCommand, ServerRefusesADatabaseThatIsInUse) {
  const TemporaryFolder folder;
  const std::string errors = folder / "errors.txt", database = folder / "site.db";
  const std::string password = "INSONATE_NEW_PASSWORD='a long password' ";
  ASSERT_EQ(
      runCommand("curriculum setup boss --full-name Boss --database " + shellWord(database), errors, password).status,
      0);
  const CommandResult run =
      runCommand("bench server --database " + shellWord(database) + " --out " + shellWord(folder / "out"), errors);
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("site.db is in use. Name an empty database"));
}

}  // namespace
}  // namespace insonate::test
