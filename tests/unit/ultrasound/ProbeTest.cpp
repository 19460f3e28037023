#include "support/TestData.h"

#include <insonate/ultrasound/SetupText.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>

namespace insonate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

nlohmann::json linearPreset() {
  std::ifstream stream(std::filesystem::path(INSONATE_SOURCE_DIR) / "resources/probes/linear.json");
  return nlohmann::json::parse(stream);
}

/// The message with which a probe file of this text is refused.
std::string refusal(const std::string& text) {
  const test::TemporaryFolder folder;
  const auto file = folder / "probe.json";
  std::ofstream(file) << text;
  const auto probe = loadProbe(file.string());
  return probe ? "accepted" : probe.error().message;
}

TEST(Probe, PresetsAreValidAndInOrder) {
  EXPECT_THAT(probePresetNames(), ElementsAre("linear", "curvilinear", "phased"));
  for (const auto& name : probePresetNames()) {
    const auto probe = loadProbe(name);
    ASSERT_TRUE(probe) << probe.error().message;
    EXPECT_EQ(probe->name, name);
    EXPECT_TRUE(validate(*probe));
  }
  EXPECT_EQ(loadProbe("linear")->shape, ProbeShape::Linear);
  EXPECT_EQ(loadProbe("linear")->width_mm, 38);
  EXPECT_EQ(loadProbe("curvilinear")->defaultFrequency_MHz, 3.5);
  EXPECT_EQ(loadProbe("phased")->fovAngle_deg, 90);
}

TEST(Probe, FileOfTheSameFormIsRead) {
  const test::TemporaryFolder folder;
  auto json = linearPreset();
  json["name"] = "mine";
  json["width_mm"] = 50;
  std::ofstream(folder / "mine.json") << json;
  const auto probe = loadProbe((folder / "mine.json").string());
  ASSERT_TRUE(probe) << probe.error().message;
  EXPECT_EQ(probe->name, "mine");
  EXPECT_EQ(probe->width_mm, 50);
}

TEST(Probe, UnknownNameListsPresets) {
  const auto probe = loadProbe("liner");
  ASSERT_FALSE(probe);
  EXPECT_THAT(probe.error().message, HasSubstr("'liner'"));
  EXPECT_THAT(probe.error().message, HasSubstr("linear, curvilinear, phased"));
  EXPECT_FALSE(loadProbe(""));
}

TEST(Probe, BadFilesAreRefusedWithASentence) {
  EXPECT_THAT(refusal(""), HasSubstr("not valid JSON"));
  EXPECT_THAT(refusal("[1, 2]"), HasSubstr("object"));
  EXPECT_THAT(refusal("{\"name\": \"x\"}"), HasSubstr("'shape' is missing"));
  const test::TemporaryFolder folder;
  EXPECT_THAT(loadProbe(folder.path().string()).error().message, HasSubstr("is a folder"));
}

TEST(Probe, BadFieldsAreRefusedByName) {
  const auto with = [](const char* field, const nlohmann::json& value) {
    auto json = linearPreset();
    json[field] = value;
    return refusal(json.dump());
  };
  EXPECT_THAT(with("width_mm", 500), HasSubstr("width_mm is 500; allowed is 5 to 200"));
  EXPECT_THAT(with("width_mm", "wide"), HasSubstr("width_mm must be a number, not \"wide\""));
  EXPECT_THAT(with("width_mm", nullptr), HasSubstr("width_mm must be a number"));
  EXPECT_THAT(with("shape", "round"), HasSubstr("one of linear, curvilinear, phased"));
  EXPECT_THAT(with("widht_mm", 38), HasSubstr("did you mean 'width_mm'"));
  EXPECT_THAT(with("fovAngle_deg", 60), HasSubstr("no meaning for a linear probe"));
  EXPECT_THAT(with("defaultFrequency_MHz", 20), HasSubstr("default frequency"));
  EXPECT_THAT(with("maxDepth_mm", 30), HasSubstr("default depth"));
  auto json = linearPreset();
  json.erase("maxAperture_mm");
  EXPECT_THAT(refusal(json.dump()), HasSubstr("'maxAperture_mm' is missing"));
}

TEST(Probe, NumbersThatAreNoneAreRefused) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), -1.0}) {
    Probe probe = *loadProbe("curvilinear");
    probe.faceRadius_mm = bad;
    ASSERT_FALSE(validate(probe));
    EXPECT_THAT(validate(probe).error().message, HasSubstr("faceRadius_mm"));
  }
}

TEST(SaveProbe, ReadsBackAsItWas) {
  const test::TemporaryFolder folder;
  for (const std::string& name : probePresetNames()) {
    Probe probe = loadProbe(name).value();
    probe.name = "Ward 3, \"old\"", probe.maxAperture_mm = 17.25;
    const auto file = folder / (name + ".json");
    ASSERT_TRUE(saveProbe(probe, file));
    const auto read = loadProbe(file.string());
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(textOf(*read), textOf(probe));
    EXPECT_EQ(textOf(parseProbe(textOf(probe)).value()), textOf(probe));
    EXPECT_EQ(read->name, probe.name);
    EXPECT_EQ(read->shape, probe.shape);
    for (const ProbeField& field : probeFields()) {
      if (!applies(field, probe.shape)) continue;
      EXPECT_EQ((*read).*field.member, probe.*field.member) << field.name;
    }
  }
  Probe wrong = loadProbe("linear").value();
  wrong.width_mm = 1;
  EXPECT_FALSE(saveProbe(wrong, folder / "wrong.json"));
  EXPECT_FALSE(std::filesystem::exists(folder / "wrong.json"));
}

}  // namespace
}  // namespace insonate
