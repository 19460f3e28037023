#include "CommandLine.h"
#include "support/SmallRender.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <optional>
#include <set>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bytesOf;
using test::shellWord;
using testing::AllOf;
using testing::HasSubstr;

/// A small case, small settings and an empty folder for outputs.
class RenderCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() { shared_.emplace(); }
  static void TearDownTestSuite() { shared_.reset(); }

  test::CommandResult render(const std::string& arguments, const std::string& prefix = "") const {
    return test::runCommand("render " + shellWord(shared_->caseFolder()) + " --engine reference --settings " +
                                shellWord(shared_->settings()) + " " + arguments,
                            shared_->errors(), prefix);
  }
  std::string out(const std::string& name) const { return (folder_ / name).string(); }
  std::set<std::string> files() const {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
      if (entry.is_regular_file()) names.insert(fs::relative(entry.path(), folder_.path()).string());
    return names;
  }
  /// The command must fail with status 1, one sentence with `words`, and nothing written.
  void expectRefusal(const std::string& arguments, const std::string& words) const {
    const auto result = render(arguments);
    EXPECT_EQ(result.status, 1) << arguments << '\n' << result.errors;
    EXPECT_THAT(result.errors, HasSubstr(words)) << arguments;
    EXPECT_EQ(result.output, "") << arguments;
    EXPECT_TRUE(files().empty()) << arguments;
  }

  static std::optional<test::SmallRender> shared_;
  test::TemporaryFolder folder_;
};
std::optional<test::SmallRender> RenderCommand::shared_;

std::string poseAt(double x_mm) {
  return R"({"position_mm": [)" + std::to_string(x_mm) + R"(, 0, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]})";
}

TEST_F(RenderCommand, ColorIsDrawnOverTheImage) {
  const std::string gray = out("gray.png"), color = out("color.png");
  ASSERT_EQ(render("--out " + shellWord(gray)).status, 0);
  const auto result = render("--color --json --out " + shellWord(color));
  ASSERT_EQ(result.status, 0) << result.errors;
  const json report = json::parse(result.output);
  EXPECT_GT(report["color"]["nyquist_mmps"], 0);
  EXPECT_TRUE(report["stages_ms"].contains("color"));
  EXPECT_NE(bytesOf(color), bytesOf(gray));
  EXPECT_THAT(report["warnings"].dump(), HasSubstr("The case names no vessels"));
}

TEST_F(RenderCommand, TheSpectrumOfAGateIsWritten) {
  const auto spectrum = [&](const std::string& arguments) {
    return test::runCommand("spectrum " + shellWord(shared_->caseFolder()) + " " + arguments, shared_->errors());
  };
  const std::string file = out("spectrum.png");
  const auto result =
      spectrum("--seconds 0.2 --json --gate " + shellWord(R"({"range_mm": 12})") + " --out " + shellWord(file));
  ASSERT_EQ(result.status, 0) << result.errors;
  const json report = json::parse(result.output);
  EXPECT_EQ(report["gate"]["range_mm"], 12);
  EXPECT_EQ(report["mean_mmps"], 0) << "the case names no vessels";
  EXPECT_GT(bytesOf(file).size(), 100U);
  const auto refused = spectrum("--gate " + shellWord(R"({"range_mm": 300})") + " --out " + shellWord(file));
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors, HasSubstr("gate: range_mm"));
}

TEST_F(RenderCommand, RefusesColorSettingsOutOfRange) {
  const std::string file = " --out " + shellWord(out("f.png"));
  expectRefusal("--color " + shellWord(R"({"prf_Hz": 100})") + file, "prf_Hz");
  expectRefusal("--color " + shellWord(R"({"speed": 1})") + file, "speed");
  expectRefusal("--color " + shellWord("{") + file, "--color");
  expectRefusal("--color " + shellWord("none.json") + file, "none.json");
}

TEST_F(RenderCommand, PointTargetsAreSeenWhereTheyAre) {
  const auto brightness = [&](const std::string& points) {
    const std::string file = out("f.png");
    EXPECT_EQ(render(points + " --out " + shellWord(file)).status, 0) << points;
    return bytesOf(file);
  };
  const std::string without = brightness("");
  const std::string onAxis = brightness("--points 6,9");
  EXPECT_NE(onAxis, without);
  std::ofstream(out("points.csv")) << "0,0,6\n\n0, 0, 9\n";
  EXPECT_EQ(brightness("--points " + shellWord(out("points.csv"))), onAxis);
}

TEST_F(RenderCommand, RefusesPointsThatAreNone) {
  for (const char* list : {"deep", "10,,20", "-5", "nan", "0"})
    expectRefusal("--points=" + std::string(list) + " --out " + shellWord(out("f.png")),
                  "is neither a file nor a list of depths above 0");
  const test::TemporaryFolder other;
  const std::string file = (other / "points.csv").string();
  const std::string arguments = "--points " + shellWord(file) + " --out " + shellWord(out("f.png"));
  std::ofstream(file) << "0,0,6\n0,6\n";
  expectRefusal(arguments, "line 2 of");
  std::ofstream(file) << "\n";
  expectRefusal(arguments, "has no points");
}

TEST_F(RenderCommand, WritesAPictureAndTellsAboutIt) {
  const auto result = render("--probe linear --pose auto --json --out " + shellWord(out("f.png")));
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(bytesOf(out("f.png")), testing::StartsWith("\x89PNG"));
  const json report = json::parse(result.output);
  EXPECT_EQ(report["engine"], "reference");
  EXPECT_EQ(report["look"], "coherent");
  EXPECT_EQ(report["scanlines"], 32);
  EXPECT_EQ(report["samples"], 128);
  EXPECT_EQ(report["width"], 96);
  EXPECT_EQ(report["height"], 80);
  EXPECT_GT(report["frame_ms"], 0);
  EXPECT_FALSE(report["stages_ms"].empty());
  EXPECT_TRUE(report["force_N"].is_null());
  EXPECT_TRUE(report["indent_mm"].is_null());
  EXPECT_EQ(report["lumens"], json::array());
  EXPECT_TRUE(report["warnings"].is_array());
  EXPECT_EQ(report["out"], out("f.png"));
  EXPECT_GT(report["mm_per_pixel"], 0);
  EXPECT_TRUE(report.contains("version"));
  EXPECT_EQ(report["pose"]["position_mm"], json({0.0, 0.0, 0.0}));
}

/// Without any OpenGL (no driver is found), auto is the processor and says why, and glsl is refused.
TEST_F(RenderCommand, SaysWhichEngineAndWhy) {
  const auto by = [&](const std::string& engine, const std::string& prefix = "") {
    return test::runCommand("render " + shellWord(shared_->caseFolder()) + " --settings " +
                                shellWord(shared_->settings()) + " --pose auto --json --out " +
                                shellWord(out("f.png")) + engine,
                            shared_->errors(), prefix);
  };
  EXPECT_EQ(json::parse(by(" --engine reference").output)["engine_note"], "") << "nothing is to be said of it";
  const json chosen = json::parse(by("").output);
  EXPECT_THAT(chosen["engine"].get<std::string>(), testing::AnyOf("cpu", "glsl"));
  EXPECT_THAT(chosen["engine_note"].get<std::string>(), testing::MatchesRegex(".+[.]"));

  const std::string noDriver = "__EGL_VENDOR_LIBRARY_DIRS=/nonexistent ";
  const json fallen = json::parse(by("", noDriver).output);
  EXPECT_EQ(fallen["engine"], "cpu");
  EXPECT_THAT(fallen["engine_note"].get<std::string>(), testing::MatchesRegex("[A-Z].*(OpenGL|EGL|graphics).*[.]"));
  const auto refused = by(" --engine glsl", noDriver);
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.errors, testing::ContainsRegex("OpenGL|EGL|graphics"));
}

TEST_F(RenderCommand, SamePoseGivesTheSameBytesHoweverItIsSaid) {
  ASSERT_EQ(render("--pose auto --out " + shellWord(out("a.png"))).status, 0);
  ASSERT_EQ(render("--pose 'over the vein' --out " + shellWord(out("b.png"))).status, 0);
  ASSERT_EQ(render("--pose " + shellWord(poseAt(0)) + " --out " + shellWord(out("c.png"))).status, 0);
  std::ofstream(out("pose.json")) << poseAt(0);
  ASSERT_EQ(render("--pose " + shellWord(out("pose.json")) + " --out " + shellWord(out("d.png"))).status, 0);
  for (const char* other : {"b.png", "c.png", "d.png"}) EXPECT_EQ(bytesOf(out("a.png")), bytesOf(out(other))) << other;
}

TEST_F(RenderCommand, APathBecomesNumberedPictures) {
  const std::string path = "[" + poseAt(0) + "," + poseAt(2) + "," + poseAt(4) + "]";
  const auto result = render("--json --pose " + shellWord(path) + " --out " + shellWord(out("f.png")));
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(files(), testing::ElementsAre("f_0000.png", "f_0001.png", "f_0002.png"));
  EXPECT_NE(bytesOf(out("f_0000.png")), bytesOf(out("f_0001.png")));
  EXPECT_EQ(json::parse(result.output)["images"].size(), 3u);

  ASSERT_EQ(render("--pose " + shellWord(poseAt(2)) + " --out " + shellWord(out("alone.png"))).status, 0);
  EXPECT_EQ(bytesOf(out("f_0001.png")), bytesOf(out("alone.png"))) << "a path must not change its pictures";
}

TEST_F(RenderCommand, EnvelopeAndLayersComeBesideThePicture) {
  const auto result = render("--json --out " + shellWord(out("f.png")) + " --envelope " + shellWord(out("e.nrrd")) +
                             " --layers " + shellWord(out("layers")));
  ASSERT_EQ(result.status, 0) << result.errors;
  const std::string nrrd = bytesOf(out("e.nrrd"));
  EXPECT_THAT(nrrd, AllOf(testing::StartsWith("NRRD"), HasSubstr("sizes: 128 32")));
  EXPECT_EQ(nrrd.size() - nrrd.find("\n\n") - 2, 128u * 32 * sizeof(float));
  const json layers = json::parse(result.output)["layers"];
  EXPECT_GE(layers.size(), 10u);
  for (const auto& [name, file] : layers.items()) EXPECT_TRUE(fs::exists(file.get<std::string>())) << name;
  EXPECT_EQ(files().size(), layers.size() + 2);
}

TEST_F(RenderCommand, ThesisLookDiffersAndHasItsLayers) {
  ASSERT_EQ(render("--out " + shellWord(out("coherent.png"))).status, 0);
  const auto result =
      render("--json --style thesis --out " + shellWord(out("thesis.png")) + " --layers " + shellWord(out("layers")));
  ASSERT_EQ(result.status, 0) << result.errors;
  const json report = json::parse(result.output);
  EXPECT_EQ(report["look"], "thesis");
  EXPECT_EQ(report["tissues"], "thesis");
  EXPECT_EQ(report["layers"].size(), 4u);
  EXPECT_NE(bytesOf(out("coherent.png")), bytesOf(out("thesis.png")));
}

TEST_F(RenderCommand, TissuesChangeThePicture) {
  std::ofstream(*shared_ / "loud.json") << R"({"base": "neck", "tissues": [{"label": "vein", "echogenicity_dB": 10}]})";
  ASSERT_EQ(render("--out " + shellWord(out("a.png"))).status, 0);
  ASSERT_EQ(render("--tissues " + shellWord(*shared_ / "loud.json") + " --out " + shellWord(out("b.png"))).status, 0);
  EXPECT_NE(bytesOf(out("a.png")), bytesOf(out("b.png")));
}

TEST_F(RenderCommand, AProbeInTheAirGivesAnImageWithoutEchoesAndAWarning) {
  const std::string pose = R"({"position_mm": [0, -3, 0], "axial": [0, -1, 0], "lateral": [1, 0, 0]})";
  const auto result = render("--json --pose " + shellWord(pose) + " --out " + shellWord(out("f.png")));
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(json::parse(result.output)["warnings"].dump(), HasSubstr("The image shows no echoes"));
}

TEST_F(RenderCommand, MachinesAreListedAndMakeTheirOwnImages) {
  const auto list = test::runCommand("machines", shared_->errors());
  ASSERT_EQ(list.status, 0);
  const json report = json::parse(test::runCommand("machines --json", shared_->errors()).output);
  ASSERT_EQ(render("--out " + shellWord(out("own.png"))).status, 0);
  std::set<std::string> images{bytesOf(out("own.png"))};
  for (const json& machine : report["machines"]) {
    const auto name = machine["name"].get<std::string>();
    EXPECT_THAT(list.output, HasSubstr(name + "\t" + machine["about"].get<std::string>()));
    const auto result = render("--machine " + name + " --out " + shellWord(out(name + ".png")));
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_TRUE(images.insert(bytesOf(out(name + ".png"))).second) << name << " looks like another";
  }
  EXPECT_EQ(images.size(), 6U);
}

TEST_F(RenderCommand, BadInputIsRefusedWithASentenceAndLeavesNothing) {
  const std::string picture = " --out " + shellWord(out("f.png"));
  expectRefusal(
      "--pose " + shellWord(R"({"position_mm": [NaN, 0, 0], "axial": [0,1,0], "lateral": [1,0,0]})") + picture, "JSON");
  expectRefusal("--pose " + shellWord(R"({"position_mm": [0, 0, 0], "axial": [0,1,0], "lateral": [0,1,0]})") + picture,
                "parallel");
  expectRefusal("--pose " + shellWord(poseAt(5000)) + picture, "shows nothing");
  expectRefusal("--pose " + shellWord("[" + poseAt(0) + "," + poseAt(5000) + "]") + picture, "Pose 1");
  expectRefusal("--pose nowhere" + picture, "nowhere");
  expectRefusal("--probe trapezoid" + picture, "trapezoid");
  expectRefusal("--tissues nek" + picture, "neck");
  expectRefusal("--machine cart-1950" + picture, "there is no machine named 'cart-1950'; machines are cart-2024");
  expectRefusal("--out " + shellWord(out("f.jpg")), ".png");
  expectRefusal("--out " + shellWord(out("none/f.png")), "does not exist");
  expectRefusal("--envelope " + shellWord(out("none/e.nrrd")) + picture, "does not exist");
  expectRefusal("--layers " + shellWord(out("none/layers")) + picture, "does not exist");
  expectRefusal("--out " + shellWord(out("")), ".png");
}

TEST_F(RenderCommand, TheCaseItselfIsNeverWrittenOver) {
  const std::string picture = " --out " + shellWord(out("f.png"));
  const fs::path ct = *shared_ / "case" / "ct.nrrd";
  const std::string before = bytesOf(ct);
  expectRefusal("--envelope " + shellWord(ct) + picture, "file of the case itself");
  expectRefusal("--envelope " + shellWord((*shared_ / "case/../case/labels.seg.nrrd").string()) + picture,
                "file of the case itself");
  EXPECT_EQ(bytesOf(ct), before);
}

TEST_F(RenderCommand, PosesThatMisleadAreSaid) {
  const auto result = render("--json --pose " + shellWord(poseAt(20)) + " --out " + shellWord(out("f.png")));
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(json::parse(result.output)["warnings"].dump(), HasSubstr("outside the scan"));
  EXPECT_THAT(result.errors, HasSubstr("outside the scan"));
}

TEST_F(RenderCommand, AbsurdSettingsAreRefusedByName) {
  for (const auto& [settings, word] : {std::pair{R"({"scanlines": -3})", "scanlines"},
                                       {R"({"samples": 1e9})", "samples"},
                                       {R"({"depth_mm": 0})", "depth_mm"},
                                       {R"({"dept_mm": 40})", "depth_mm"},
                                       {R"({"frequency_MHz": 400})", "frequency_MHz"},
                                       {"[]", "settings"},
                                       {"{", "JSON"}}) {
    std::ofstream(*shared_ / "settings.json") << settings;
    const auto result =
        test::runCommand("render " + shellWord(shared_->caseFolder()) + " --settings " +
                             shellWord(*shared_ / "settings.json") + " --out " + shellWord(out("f.png")),
                         shared_->errors());
    EXPECT_EQ(result.status, 1) << settings;
    EXPECT_THAT(result.errors, HasSubstr(word)) << settings;
    EXPECT_TRUE(files().empty());
  }
}

TEST_F(RenderCommand, AMissingCaseSettingsOrEngineIsRefused) {
  const std::string right = shellWord((*shared_ / "case").string()), picture = " --out " + shellWord(out("f.png"));
  for (const auto& [arguments, word] : {std::pair{shellWord(out("nocase")), "nocase"},
                                        {right + " --settings " + shellWord(out("none.json")), "none.json"},
                                        {right + " --engine warp", "warp"}}) {
    const auto result = test::runCommand("render " + arguments + picture, shared_->errors());
    EXPECT_EQ(result.status, 1) << arguments;
    EXPECT_THAT(result.errors, HasSubstr(word));
    EXPECT_TRUE(files().empty());
  }
}

TEST_F(RenderCommand, WrongUsageHasStatusTwo) {
  EXPECT_EQ(render("").status, 2);
  EXPECT_EQ(render("--look pretty --out " + shellWord(out("f.png"))).status, 2);
  EXPECT_TRUE(files().empty());
}

TEST_F(RenderCommand, AFullDiskKeepsTheOldPicture) {
  std::ofstream(out("f.png")) << "old";
  // A limit of one block on file sizes fails like a full disk, in the middle of writing.
  const auto result = render("--envelope " + shellWord(out("e.nrrd")) + " --out " + shellWord(out("f.png")),
                             "trap '' XFSZ; ulimit -f 1; ");
  EXPECT_EQ(result.status, 1) << result.errors;
  EXPECT_FALSE(result.errors.empty());
  EXPECT_THAT(files(), testing::ElementsAre("f.png"));
  EXPECT_EQ(bytesOf(out("f.png")), "old");
}

}  // namespace
}  // namespace insonate
