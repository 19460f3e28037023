#include "integration/CommandLine.h"
#include "support/SmallCase.h"
#include "support/TestData.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class SurfacesCommand : public testing::Test {
 protected:
  void SetUp() override {
    const auto written = writeCase(smallCase(), folder_ / "case");
    ASSERT_TRUE(written) << written.error().message;
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  CommandResult surfaces(const std::string& arguments, const std::string& prefix = "") const {
    return runCommand("surfaces " + arguments, path("errors.txt"), prefix);
  }
  CommandResult toFolder(const std::string& name, const std::string& options = "",
                         const std::string& prefix = "") const {
    return surfaces(shellWord(path("case")) + " " + shellWord(path(name)) + " " + options, prefix);
  }
  TemporaryFolder folder_;
};

TEST_F(SurfacesCommand, OneFileForEachStructureWithItsMeasures) {
  const auto result = toFolder("meshes", "--json");
  ASSERT_EQ(result.status, 0) << result.errors;
  const json report = json::parse(result.output);
  EXPECT_TRUE(report["version"].is_string());
  std::vector<std::string> names;
  for (const json& surface : report["surfaces"]) {
    names.push_back(surface["name"]);
    const fs::path file = surface["file"].get<std::string>();
    ASSERT_TRUE(fs::exists(file)) << file;
    EXPECT_EQ(fs::file_size(file), 84 + 50 * surface["triangles"].get<std::size_t>()) << "binary STL";
    EXPECT_GT(surface["area_mm2"].get<double>(), 0);
    if (surface["label"] != kVein) continue;
    EXPECT_NEAR(surface["volume_mm3"].get<double>() / (69 * 17), 1, 0.01) << "69 voxels of 1 mm3 in each of 17 slices";
    EXPECT_EQ(file.filename(), "vein.stl");
  }
  EXPECT_THAT(names, testing::ElementsAre("skin", "vein", "bone", "soft tissue"));
  EXPECT_TRUE(fs::exists(folder_ / "meshes/soft-tissue.stl"));
}

TEST_F(SurfacesCommand, OtherFormatsIntoAnEmptyFolder) {
  fs::create_directory(folder_ / "empty");
  ASSERT_EQ(toFolder("empty", "--format ply").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "empty/vein.ply"));
  const auto result = toFolder("objects", "--format obj --detail 2 --smoothing 0");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_TRUE(fs::exists(folder_ / "objects/bone.obj"));
  EXPECT_THAT(result.output, HasSubstr("bone.obj"));
}

TEST_F(SurfacesCommand, RefusalsSayWhyAndLeaveNothing) {
  fs::create_directory(folder_ / "full");
  std::ofstream(folder_ / "full/notes.txt") << "mine";
  std::ofstream(folder_ / "file") << "text";
  PatientCase unlabeled = smallCase();
  unlabeled.labels = LabelMap(unlabeled.ct.geometry);
  ASSERT_TRUE(writeCase(unlabeled, folder_ / "unlabelled"));

  EXPECT_THAT(toFolder("full").errors, HasSubstr("not empty"));
  EXPECT_THAT(toFolder("file").errors, HasSubstr("is a file"));
  EXPECT_THAT(toFolder("none/meshes").errors, HasSubstr("does not exist"));
  EXPECT_THAT(toFolder("meshes", "--detail nan").errors, HasSubstr("detail_mm"));
  const auto nothing = surfaces(shellWord(path("unlabelled")) + " " + shellWord(path("meshes")) + " --json");
  EXPECT_EQ(nothing.status, 1);
  EXPECT_THAT(json::parse(nothing.output)["error"].get<std::string>(), HasSubstr("Nothing is labeled"));
  const auto missing = surfaces(shellWord(path("nocase")) + " " + shellWord(path("meshes")));
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.errors, HasSubstr("nocase"));
  EXPECT_FALSE(fs::exists(folder_ / "meshes"));
  EXPECT_TRUE(fs::exists(folder_ / "full/notes.txt"));
}

TEST_F(SurfacesCommand, AFullDiskLeavesNothing) {
  // A limit of one block on file sizes fails like a full disk, in the middle of writing.
  const auto result = toFolder("meshes", "", "trap '' XFSZ; ulimit -f 1; ");
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.errors, AllOf(HasSubstr("Could not write"), HasSubstr("meshes/skin.stl")));
  std::vector<std::string> left;
  for (const auto& entry : fs::directory_iterator(folder_.path())) left.push_back(entry.path().filename());
  EXPECT_THAT(left, testing::UnorderedElementsAre("case", "errors.txt"));
}

TEST_F(SurfacesCommand, WrongUsageHasStatusTwo) {
  EXPECT_EQ(surfaces("").status, 2);
  EXPECT_EQ(surfaces(shellWord(path("case"))).status, 2);
  EXPECT_EQ(toFolder("meshes", "--format vtk").status, 2);
  EXPECT_EQ(toFolder("meshes", "--detail fine").status, 2);
  EXPECT_FALSE(fs::exists(folder_ / "meshes"));
}

}  // namespace
}  // namespace insonate::test
