#include "RenderTest.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <sstream>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bytesOf;
using test::shellWord;
using testing::HasSubstr;

/// The small block under a short probe.
class PressCommand : public test::RenderTest {
 protected:
  json report(const std::string& arguments) const {
    const auto result = render("--json " + arguments);
    EXPECT_EQ(result.status, 0) << arguments << '\n' << result.errors;
    return json::parse(result.output);
  }
  void expectRefusal(const std::string& arguments, const std::string& words, int status = 1) const {
    fs::remove(out("f.png"));
    const auto result = render(arguments);
    EXPECT_EQ(result.status, status) << arguments << '\n' << result.errors;
    EXPECT_THAT(result.errors, HasSubstr(words)) << arguments;
    EXPECT_FALSE(fs::exists(out("f.png"))) << arguments;
  }
};

double veinArea(const json& report) {
  for (const json& lumen : report["lumens"])
    if (lumen["label"] == "vein") return lumen["area_mm2"];
  return NAN;
}

TEST_F(PressCommand, MoreForceFlattensTheVeinMore) {
  double area_mm2 = 1e9, indent_mm = 0;
  for (const char* force : {"0.2", "0.5", "1"}) {
    const json pressed = report(std::string("--force ") + force);
    EXPECT_NEAR(pressed["force_N"], std::stod(force), 0.02);
    EXPECT_EQ(pressed["deformation"], "elastic");
    EXPECT_LT(veinArea(pressed), area_mm2) << force;
    EXPECT_GT(pressed["indent_mm"], indent_mm) << force;
    EXPECT_NEAR(pressed["lumens"][0]["rest_area_mm2"], 69, 2) << "voxels";
    area_mm2 = veinArea(pressed), indent_mm = pressed["indent_mm"];
    // The pose is where the face has gone: the skin lies at -0.5 mm.
    EXPECT_NEAR(pressed["pose"]["position_mm"][1], indent_mm - 0.5, 0.3);
  }
}

TEST_F(PressCommand, IndentationIsFromWhereTheFaceFirstTouches) {
  const char* above = R"('{"position_mm": [0, -8, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}')";
  const char* inside = R"('{"position_mm": [0, 5, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}')";
  const json a = report(std::string("--indent 3 --pose ") + above),
             b = report(std::string("--indent 3 --pose ") + inside);
  EXPECT_NEAR(a["indent_mm"], 3, 0.02);
  EXPECT_NEAR(a["pose"]["position_mm"][1], 2.5, 0.3);
  EXPECT_NEAR(a["pose"]["position_mm"][1], double(b["pose"]["position_mm"][1]), 0.05);
  EXPECT_NEAR(a["force_N"], double(b["force_N"]), 0.02 * double(a["force_N"]));
  EXPECT_GT(a["force_N"], 0.1);
  // The indentation that a force causes, when requested, needs the same force.
  std::ostringstream force;
  force << "--force " << double(a["force_N"]);
  EXPECT_NEAR(report(force.str())["indent_mm"], 3, 0.1);
}

TEST_F(PressCommand, NoForceShowsWhatIsShownWithout) {
  const std::string without = picture("");
  EXPECT_EQ(picture("--deformation none"), without);
  const json none = report("--force 0"), model = report("--indent 0");
  EXPECT_EQ(none["force_N"], 0);
  EXPECT_EQ(none["indent_mm"], 0);
  EXPECT_NEAR(model["force_N"], 0, 0.03);
  EXPECT_NEAR(veinArea(none), 69, 2) << "told at rest, too";
  EXPECT_NE(picture("--force 0.5"), without);
}

TEST_F(PressCommand, EachModelHasItsOwnPicture) {
  const std::string elastic = picture("--indent 3 --deformation elastic"),
                    column = picture("--indent 3 --deformation column"),
                    none = picture("--indent 3 --deformation none");
  EXPECT_NE(elastic, column);
  EXPECT_NE(elastic, none);
  EXPECT_NE(column, none);
  EXPECT_TRUE(report("--indent 3 --deformation none")["force_N"].is_null());
  EXPECT_EQ(report("--indent 3 --deformation column")["deformation"], "column");
}

TEST_F(PressCommand, VeinsFillWithPressureAndPosture) {
  const double supine = veinArea(report("--indent 0 --cvp 4.5"));
  EXPECT_GT(veinArea(report("--indent 0 --trendelenburg 15")), 1.05 * supine);
  EXPECT_LT(veinArea(report("--indent 0 --trendelenburg=-15")), 0.95 * supine);
  EXPECT_GT(veinArea(report("--indent 0 --cvp 10")), 1.05 * supine);
  EXPECT_NE(veinArea(report("--indent 0 --time 0.5")), veinArea(report("--indent 0 --time 2.5")));
  EXPECT_GT(double(report("--force 0.5 --mechanics thesis")["force_N"]), 0.4);
}

TEST_F(PressCommand, TheDisplacementIsAVectorVolume) {
  report("--indent 3 --displacement " + shellWord(out("u.nrrd")));
  const std::string bytes = bytesOf(out("u.nrrd"));
  ASSERT_THAT(bytes, HasSubstr("kinds: vector domain domain domain"));
  std::istringstream sizes(bytes.substr(bytes.find("sizes:") + 6));
  std::array<std::size_t, 4> n{};
  for (std::size_t& size : n) sizes >> size;
  const std::size_t data = bytes.find("\n\n") + 2;
  ASSERT_EQ(bytes.size() - data, n[0] * n[1] * n[2] * n[3] * sizeof(float));
  double max_mm = 0;
  for (std::size_t i = 0; i < n[1] * n[2]; ++i) {
    std::array<float, 3> shift{};
    std::memcpy(shift.data(), bytes.data() + data + i * sizeof shift, sizeof shift);
    ASSERT_TRUE(std::isfinite(shift[0]) && std::isfinite(shift[1]));
    EXPECT_NEAR(shift[2], 0, 1e-4) << "the plane is x and y here";
    if (i / n[1] < n[2] / 6) max_mm = std::max<double>(max_mm, -shift[1]);  // above the vein
  }
  EXPECT_NEAR(max_mm, 3, 0.4) << "under the face the skin was 3 mm up";

  report("--deformation none --displacement " + shellWord(out("still.nrrd")));
  EXPECT_THAT(bytesOf(out("still.nrrd")), HasSubstr("kinds: vector"));
}

TEST_F(PressCommand, BoneIsNotPressedThrough) {
  expectRefusal("--pose '{\"position_mm\": [0, 0, 0], \"axial\": [0, -1, 0], \"lateral\": [1, 0, 0]}' --indent 20",
                "meets no skin");
  const json pressed = report("--force 50");
  EXPECT_THAT(pressed["warnings"].dump(), HasSubstr("the probe stops at"));
  EXPECT_LT(pressed["pose"]["position_mm"][1], 25.5);
}

TEST_F(PressCommand, APathIsPressedEverywhere) {
  const std::string path =
      R"('[{"position_mm": [0, 0, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]},
           {"position_mm": [3, -4, 0], "axial": [0, 1, 0], "lateral": [1, 0, 0]}]')";
  const json images = report("--indent 2 --pose " + path)["images"];
  ASSERT_EQ(images.size(), 2u);
  for (const json& image : images) {
    EXPECT_NEAR(image["indent_mm"], 2, 0.02);
    EXPECT_GT(image["force_N"], 0);
    EXPECT_FALSE(image["lumens"].empty());
  }
}

TEST_F(PressCommand, NonsenseIsRefusedByName) {
  expectRefusal("--force -1", "--force");
  expectRefusal("--force nan", "--force");
  expectRefusal("--force 1e9", "50 N");
  expectRefusal("--indent 70", "20 mm");
  expectRefusal("--force 1 --deformation jelly", "jelly");
  expectRefusal("--force 1 --deformation none", "--deformation none");
  expectRefusal("--force 1 --mechanics mesured", "measured");
  expectRefusal("--indent 1 --cvp 99", "centralVenous");
  expectRefusal("--indent 1 --pressure 120", "120/80");
  expectRefusal("--indent 1 --pressure 80/120", "iastolic");
  expectRefusal("--indent 1 --map 90 --pressure 120/80", "Give only one");
  expectRefusal("--indent 1 --footprint 0", "footprint");
  expectRefusal("--indent 1 --displacement " + shellWord(out("u.png")), ".nrrd");
  expectRefusal("--indent 1 --displacement " + shellWord(*shared_ / "case" / "ct.nrrd"), "file of the case itself");
  expectRefusal("--force 1 --indent 2", "", 2);
  expectRefusal("--force strong", "", 2);
}

}  // namespace
}  // namespace insonate
