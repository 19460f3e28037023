#include "integration/CommandLine.h"
#include "support/FovCapture.h"
#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/simulator/ImageFiles.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace insonate::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

FovCapture sector() {
  FovCapture capture;
  capture.shape.shape = ProbeShape::Curvilinear;
  capture.shape.origin = {480, -20}, capture.shape.rotation_deg = 2;
  capture.shape.alpha_deg = 60, capture.shape.r1_px = 160, capture.shape.r2_px = 680;
  capture.text = true;
  return capture;
}

class FitCommand : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string written(const FovCapture& capture, const std::string& name) const {
    GrayImage picture = paint(capture);
    BModeImage image{.width = picture.width, .height = picture.height, .pixel_mm = 1, .gray = std::move(picture.gray)};
    EXPECT_TRUE(writePng(image, path(name)));
    return shellWord(path(name));
  }
  CommandResult fit(const std::string& arguments) const { return runCommand("fit " + arguments, path("errors.txt")); }
  TemporaryFolder folder_;
};

TEST_F(FitCommand, PictureBecomesAProbeThatRenders) {
  FovCapture capture = sector();
  capture.mark_px = 40;
  const auto result = fit(written(capture, "capture.png") + " --json --out " + shellWord(path("ward.json")) +
                          " --overlay " + shellWord(path("over.png")));
  ASSERT_EQ(result.status, 0) << result.errors;
  const json report = json::parse(result.output);
  EXPECT_EQ(report["shape"], "curvilinear");
  EXPECT_NEAR(report["alpha_deg"], 60, 1);
  EXPECT_NEAR(report["rotation_deg"], 2, 0.5);
  EXPECT_NEAR(report["mm_per_px"], 0.25, 0.005);
  const auto probe = loadProbe(path("ward.json"));
  ASSERT_TRUE(probe) << probe.error().message;
  EXPECT_EQ(probe->name, "ward");
  EXPECT_NEAR(probe->faceRadius_mm, 40, 0.8);
  EXPECT_NEAR(probe->defaultDepth_mm, 130, 2.6);
  const auto over = readGrayImage(path("over.png"));
  ASSERT_TRUE(over);
  EXPECT_EQ(over->width, 960);

  ASSERT_TRUE(writeCase(smallCase(), folder_ / "case"));
  const auto rendered = runCommand("render " + shellWord(path("case")) + " --json --probe " +
                                       shellWord(path("ward.json")) + " --out " + shellWord(path("picture.png")),
                                   path("errors.txt"));
  ASSERT_EQ(rendered.status, 0) << rendered.errors;
  EXPECT_EQ(json::parse(rendered.output)["probe"], "ward");
}

TEST_F(FitCommand, ATypedDepthIsTheScale) {
  const std::string picture = written(sector(), "capture.png");
  const auto none = fit(picture + " --json --out " + shellWord(path("probe.json")));
  EXPECT_EQ(none.status, 1);
  EXPECT_THAT(json::parse(none.output)["error"].get<std::string>(), HasSubstr("--depth-mm"));
  EXPECT_FALSE(std::filesystem::exists(path("probe.json")));
  const auto typed = fit(picture + " --depth-mm 104 --base phased --name Ward --out " + shellWord(path("probe.json")));
  ASSERT_EQ(typed.status, 0) << typed.errors;
  EXPECT_THAT(typed.output, HasSubstr("104.0 mm"));
  const auto probe = loadProbe(path("probe.json"));
  ASSERT_TRUE(probe);
  EXPECT_EQ(probe->name, "Ward");
  EXPECT_NEAR(probe->faceRadius_mm, 32, 0.7);
  EXPECT_EQ(probe->maxAperture_mm, loadProbe("phased")->maxAperture_mm);
}

TEST_F(FitCommand, TwoPointsAreTheScale) {
  const std::string picture = written(sector(), "capture.png");
  const auto result = fit(picture + " --json --points 480 140 480 540 100");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_NEAR(json::parse(result.output)["mm_per_px"], 0.25, 1e-9);
  EXPECT_THAT(fit(picture + " --points 5 5 5 5 100").errors, HasSubstr("two different points"));
  EXPECT_EQ(fit(picture + " --points 5 5 6").status, 2);
}

TEST_F(FitCommand, RefusesWithASentence) {
  EXPECT_THAT(fit(shellWord(path("none.png"))).errors, HasSubstr("There is no image file"));
  std::ofstream(path("text.png")) << "no image";
  EXPECT_THAT(fit(shellWord(path("text.png"))).errors, HasSubstr("neither PNG nor JPEG"));
  std::ofstream(path("broken.png"), std::ios::binary) << "\x89PNG\r\n\x1a\nrest";
  EXPECT_THAT(fit(shellWord(path("broken.png"))).errors, HasSubstr("damaged"));
  std::ofstream(path("broken.jpg"), std::ios::binary) << "\xff\xd8\xff\xe0rest";
  EXPECT_THAT(fit(shellWord(path("broken.jpg"))).errors, HasSubstr("damaged"));
  FovCapture black = sector();
  black.shape.origin = {5000, 5000}, black.text = false;
  const auto result = fit(written(black, "black.png"));
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.errors, HasSubstr("No field of view was found"));
  EXPECT_EQ(fit("").status, 2);
}

struct RealCapture {
  const char* file;
  const char* shape;
  double depth_px;  ///< measured by hand
};

class RealCaptures : public FitCommand, public testing::WithParamInterface<RealCapture> {};

TEST_P(RealCaptures, AreFitted) {
  const std::string folder = "real-ultrasound/";
  INSONATE_NEEDS_DATA(folder + GetParam().file);
  const auto result = fit(shellWord(testData(folder + GetParam().file).string()) + " --json");
  ASSERT_EQ(result.status, 0) << result.errors;
  const json report = json::parse(result.output);
  EXPECT_EQ(report["shape"], GetParam().shape);
  EXPECT_NEAR(report["depth_px"].get<double>() / GetParam().depth_px, 1, 0.04);
}

INSTANTIATE_TEST_SUITE_P(Machines, RealCaptures,
                         testing::Values(RealCapture{"screens/s09_butterfly_phantom.jpg", "linear", 773},
                                         RealCapture{"screens/s10_clarius_linear_ocular_phantom.png", "linear", 786},
                                         RealCapture{"screens/s15_slicer_anonymize_convex.jpg", "curvilinear", 459},
                                         RealCapture{"screens/s21_bk_wide_curved_fan.png", "curvilinear", 333},
                                         RealCapture{"screens/s32_convex_lung_whole_fan.jpg", "curvilinear", 481},
                                         RealCapture{"neck/n20_handheld_cca_long_a.png", "linear", 504}),
                         [](const auto& row) { return "Row" + std::to_string(row.index); });

}  // namespace
}  // namespace insonate::test
