#include "CommandLine.h"
#include "support/SmallCase.h"
#include "support/TestData.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>

namespace insonate::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class SessionCommand : public testing::Test {
 protected:
  void SetUp() override {
    const auto written = writeCase(smallAttemptCase(), folder / "case");
    ASSERT_TRUE(written) << written.error().message;
    std::ofstream(folder / "attempt.json") << R"({"acts": [{"probe": "auto"},
      {"needle": {"from_mm": [0, -5, 0], "to": "vein"}}, {"advance_mm": 27}, {"withdraw_mm": 10}]})";
  }
  CommandResult run(const std::string& arguments) const { return runCommand(arguments, folder / "errors.txt"); }
  std::string path(const std::string& name) const { return shellWord(folder / name); }

  const TemporaryFolder folder;
};

TEST_F(SessionCommand, AnAttemptAndItsReplayTellTheSame) {
  const auto session =
      run("session " + path("case") + " --script " + path("attempt.json") + " --record " + path("a") + " --json");
  ASSERT_EQ(session.status, 0) << session.errors;
  const json told = json::parse(session.output);
  EXPECT_EQ(told["status"], "completed");
  EXPECT_EQ(told["metrics"]["vein_punctures"], 1);
  EXPECT_EQ(told["metrics"]["double_punctures"], 1);
  EXPECT_EQ(told["metrics"]["artery_punctures"], 0);
  EXPECT_EQ(told["metrics"]["used_needle_insertions"], 0);
  EXPECT_GT(told["metrics"]["time_to_vein_s"], 0);
  EXPECT_TRUE(told["metrics"].at("nearest_lung_mm").is_null()) << "there is none";
  const auto isLeft = [](const json& event) { return event["kind"] == "left"; };
  const auto left = std::find_if(told["events"].begin(), told["events"].end(), isLeft);
  ASSERT_NE(left, told["events"].end());
  EXPECT_EQ((*left)["wall"], "vein");
  EXPECT_GT((*left)["t_s"], (*std::prev(left))["t_s"]);
  EXPECT_EQ(told["findings"][0]["rule"], "steep") << "square to the skin";
  EXPECT_EQ(told["findings"][1]["rule"], "back wall");
  EXPECT_EQ(told["succeeded"], true) << "drawn back into the vein";
  EXPECT_TRUE(told.contains("version"));
  EXPECT_THAT(told["score"]["advice"].get<std::string>(), HasSubstr("stop as soon as the tip is visible"));
  EXPECT_EQ(told["score"]["metrics"][2]["novice"], 0.49);
  EXPECT_EQ(told["score"]["metrics"][2]["share"], 0);
  EXPECT_TRUE(told["score"]["metrics"][0]["novice"].is_null()) << "none is known";

  const auto replay = run("replay " + path("a") + " --metrics --json");
  ASSERT_EQ(replay.status, 0) << replay.errors;
  const json again = json::parse(replay.output);
  for (const char* same : {"status", "metrics", "events", "score"}) EXPECT_EQ(again[same], told[same]) << same;
  EXPECT_THAT(again["recorded_by"].get<std::string>(), testing::StartsWith("insonate "));
  const json early = json::parse(run("replay " + path("a") + " --metrics --until 1 --json").output);
  EXPECT_EQ(early["metrics"]["vein_punctures"], 0);
  EXPECT_FALSE(json::parse(run("replay " + path("a") + " --json").output).contains("metrics"));
  EXPECT_THAT(run("replay " + path("a") + " --metrics").output, HasSubstr("vein punctures (vein_punctures)"));
}

TEST_F(SessionCommand, AnAttemptBecomesAVideoOrAClip) {
  ASSERT_EQ(run("session " + path("case") + " --script " + path("attempt.json") + " --record " + path("a")).status, 0);
  const std::string command = "video " + path("a") + " " + path("case") + " --fps 2 --json --out ";
  const auto video = run(command + path("a.webm"));
  ASSERT_EQ(video.status, 0) << video.errors;
  const json told = json::parse(video.output);
  EXPECT_EQ(told["fps"], 2);
  EXPECT_EQ(told["bytes"], std::filesystem::file_size(folder / "a.webm"));
  EXPECT_EQ(told["length_s"], json::parse(run("replay " + path("a") + " --json").output)["end_s"]);
  EXPECT_EQ(std::ifstream(folder / "a.webm", std::ios::binary).get(), 0x1A) << "the beginning of a WebM file";

  const auto clip = run(command + path("a.dcm"));
  ASSERT_EQ(clip.status, 0) << clip.errors;
  EXPECT_EQ(json::parse(clip.output)["bytes"], std::filesystem::file_size(folder / "a.dcm"));
  EXPECT_EQ(bytesOf(folder / "a.dcm").substr(128, 4), "DICM");
  EXPECT_THAT(bytesOf(folder / "a.dcm"), HasSubstr("SIMULATED ultrasound, internal_jugular"));
  const auto other = run(command + path("a.mkv"));
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.errors, HasSubstr("must end in .webm (video) or .dcm (DICOM clip)"));

  const auto unknown = run("video " + path("a") + " --out " + path("b.webm"));
  EXPECT_EQ(unknown.status, 1);
  EXPECT_THAT(unknown.errors, HasSubstr("The attempt's case, 'Small block', is not here"));
  const auto damaged = run("video " + path("attempt.json") + " " + path("case") + " --out " + path("b.webm"));
  EXPECT_EQ(damaged.status, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.webm"));
  EXPECT_EQ(run("video " + path("a") + " --out " + path("b.webm") + " --fps 0").status, 2);
}

TEST_F(SessionCommand, AProcedureThatTheCaseIsNotForIsRefusedAndLeavesNothing) {
  std::ofstream(folder / "below.json") << R"({"procedure": "subclavian", "acts": [{"wait_s": 1}]})";
  const auto refused = run("session " + path("case") + " --script " + path("below.json") + " --record " + path("a"));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors, HasSubstr("nothing is labeled airway and lung"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a"));
}

std::map<std::string, std::string> filesIn(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    files[entry.path().filename().string()] = bytesOf(entry.path());
  return files;
}

/// The probe presses, the needle goes through the vein: images of the session and of two replays are the same files.
TEST_F(SessionCommand, PicturesOfASessionAndItsReplaysAgreeByteForByte) {
  std::ofstream(folder / "press.json") << R"({"acts": [
    {"probe": {"position_mm": [0, 3, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}},
    {"needle": {"from_mm": [-8, -5, 0], "to": "vein"}}, {"advance_mm": 22, "speed_mmps": 20}, {"tilt_deg": 15},
    {"wait_s": 0.3}, {"probe": null}, {"wait_s": 0.5}]})";
  const auto session = run("session " + path("case") + " --script " + path("press.json") + " --record " + path("a") +
                           " --pictures " + path("first") + " --every 0.25 --json");
  ASSERT_EQ(session.status, 0) << session.errors;
  const auto first = filesIn(folder / "first");
  ASSERT_EQ(first.size(), 6u) << "1.4 s of a probe that is held: five, and what they are";
  EXPECT_TRUE(first.contains("0001250_ms.png"));
  const json told = json::parse(session.output)["pictures"];
  EXPECT_EQ(json::parse(first.at("pictures.json")), told);
  EXPECT_GT(told[0]["force_N"], 0.05);
  EXPECT_NEAR(told[0]["indent_mm"], 3.5, 0.1);
  EXPECT_NE(first.at("0000750_ms.png"), first.at("0001000_ms.png")) << "the needle goes on";
  const std::string replay = "replay " + path("a") + " " + path("case") + " --images ";
  ASSERT_EQ(run(replay + path("second") + " --every 0.25").status, 0);
  EXPECT_EQ(filesIn(folder / "second"), first);
  ASSERT_EQ(run(replay + path("some") + " --every 0.5").status, 0);
  EXPECT_EQ(filesIn(folder / "some").at("0001000_ms.png"), first.at("0001000_ms.png")) << "whatever came before";

  EXPECT_THAT(run(replay + path("second")).errors, HasSubstr("second already contains files"));
  EXPECT_THAT(run("replay " + path("a") + " --pictures " + path("third")).errors, HasSubstr("needs the case"));
  EXPECT_EQ(run(replay + path("third") + " --every 0").status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "third"));
}

TEST_F(SessionCommand, Refusals) {
  const std::string session = "session " + path("case") + " --script ";
  EXPECT_THAT(run(session + path("none.json") + " --record " + path("a")).errors, HasSubstr("is neither a script ("));
  std::ofstream(folder / "bad.json") << R"({"acts": [{"advance": 3}]})";
  const auto bad = run(session + path("bad.json") + " --record " + path("a"));
  EXPECT_EQ(bad.status, 1);
  EXPECT_THAT(
      bad.errors,
      HasSubstr("bad.json: The script cannot be used: act 1 has an unknown 'advance'; did you mean 'advance_mm'?"));
  std::ofstream(folder / "there") << "text";
  const auto there = run(session + path("attempt.json") + " --record " + path("there") + " --json");
  EXPECT_EQ(there.status, 1);
  EXPECT_THAT(json::parse(there.output)["error"].get<std::string>(), HasSubstr("are never overwritten"));
  EXPECT_THAT(run("replay " + path("there")).errors, HasSubstr("is not a recording of an attempt"));
  EXPECT_EQ(run("session " + path("case")).status, 2);
  EXPECT_FALSE(std::filesystem::exists(folder / "a"));
}

}  // namespace
}  // namespace insonate::test
