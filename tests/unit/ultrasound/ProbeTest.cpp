#include "support/TestData.h"

#include <insonate/ultrasound/PointSpread.h>
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
  EXPECT_EQ(loadProbe("linear")->faceMargin_mm, 2);
  EXPECT_EQ(loadProbe("curvilinear")->faceMargin_mm, 2);
  EXPECT_EQ(loadProbe("phased")->faceMargin_mm, 1.2);
}

TEST(Probe, FilesWithoutAMarginOfTheFaceHaveThatOfALinearProbe) {
  auto json = linearPreset();
  json["faceMargin_mm"] = 0;
  EXPECT_EQ(parseProbe(json.dump())->faceMargin_mm, 0);
  json.erase("faceMargin_mm");
  const auto former = parseProbe(json.dump());
  ASSERT_TRUE(former) << former.error().message;
  EXPECT_EQ(former->faceMargin_mm, 2);
  json["faceMargin_mm"] = -1;
  EXPECT_THAT(refusal(json.dump()), HasSubstr("needs a number from 0 to 20 as 'faceMargin_mm', not -1."));
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
  EXPECT_THAT(refusal("{\"name\": \"x\"}"), HasSubstr("has no 'shape'"));
  const test::TemporaryFolder folder;
  EXPECT_THAT(loadProbe(folder.path().string()).error().message, HasSubstr("nor a file"));
}

TEST(Probe, BadFieldsAreRefusedByName) {
  const auto with = [](const char* field, const nlohmann::json& value) {
    auto json = linearPreset();
    json[field] = value;
    return refusal(json.dump());
  };
  EXPECT_THAT(with("width_mm", 500), HasSubstr("needs a number from 5 to 200 as 'width_mm', not 500."));
  EXPECT_THAT(with("width_mm", "wide"), HasSubstr("as 'width_mm', not \"wide\"."));
  EXPECT_THAT(with("width_mm", nullptr), HasSubstr("as 'width_mm', not null."));
  EXPECT_THAT(with("shape", "round"),
              HasSubstr("has the unknown shape 'round'; it is one of linear, curvilinear, phased."));
  EXPECT_THAT(with("apodization", "hamming"),
              HasSubstr("has the unknown apodization 'hamming'; it is one of uniform, tukey, hann."));
  EXPECT_THAT(with("widht_mm", 38), HasSubstr("did you mean 'width_mm'"));
  EXPECT_THAT(with("fovAngle_deg", 60), HasSubstr("no meaning for a linear probe"));
  EXPECT_THAT(with("defaultFrequency_MHz", 20), HasSubstr("default frequency"));
  EXPECT_THAT(with("maxDepth_mm", 30), HasSubstr("default depth"));
  auto json = linearPreset();
  json.erase("maxAperture_mm");
  EXPECT_THAT(refusal(json.dump()), HasSubstr("has no 'maxAperture_mm'."));
}

/// The built-in linear probe as files had it until November 2026.
constexpr const char* kFormerLinear = R"({"name": "old", "shape": "linear", "width_mm": 38, "minFrequency_MHz": 5,
  "maxFrequency_MHz": 13, "defaultFrequency_MHz": 7.5, "minDepth_mm": 20, "maxDepth_mm": 120, "defaultDepth_mm": 40,
  "defaultFocus_mm": 20, "axialFwhm_wavelengths": 1.27, "lateralFNumber": 3.0, "maxAperture_mm": 30,
  "lateralDivergenceNear": 0.020, "lateralDivergenceFar": 0.028, "elevationFocus_mm": 20,
  "elevationFwhm_wavelengths": 5.4, "elevationDivergence": 0.085})";

TEST(Probe, FilesThatStateWidthsBecomeTheArrayThatHasThem) {
  const auto probe = parseProbe(kFormerLinear);
  ASSERT_TRUE(probe) << probe.error().message;
  const ImagingSettings settings = settingsFor(*probe);
  constexpr double kWavelength_mm = 1.54 / 7.5;
  EXPECT_NEAR(axialFwhm_mm(*probe, settings), 1.27 * kWavelength_mm, 1e-3);
  EXPECT_NEAR(lateralFwhm_mm(*probe, settings, 20), 3 * kWavelength_mm, 1e-3);
  EXPECT_NEAR(probe->elementHeight_mm, 0.98 * 20 / 5.4, 1e-9);
  EXPECT_EQ(probe->apodization, Apodization::Hann);
  EXPECT_EQ(probe->maxAperture_mm, 30);
  EXPECT_EQ(probe->elevationFocus_mm, 20);
  EXPECT_EQ(probe->pitch_mm, 0.2);
  EXPECT_EQ(probe->faceMargin_mm, 2);
  EXPECT_EQ(textOf(*parseProbe(textOf(*probe))), textOf(*probe)) << "written by the new names";
}

TEST(Probe, FormerFilesThatAreBadAreRefusedByName) {
  const auto with = [](const char* field, const nlohmann::json& value) {
    auto json = nlohmann::json::parse(kFormerLinear);
    if (value.is_null())
      json.erase(field);
    else
      json[field] = value;
    return refusal(json.dump());
  };
  EXPECT_THAT(with("elevationFwhm_wavelengths", nullptr), HasSubstr("has no 'elevationFwhm_wavelengths'."));
  EXPECT_THAT(with("lateralFNumber", "wide"),
              HasSubstr("needs a number from 0.5 to 400 as 'lateralFNumber', not \"wide\"."));
  EXPECT_THAT(with("axialFwhm_wavelengths", 0), HasSubstr("as 'axialFwhm_wavelengths', not 0."));
  EXPECT_THAT(with("receiveFNumber", 1.5), HasSubstr("has 'receiveFNumber', which describes the array"));
  EXPECT_THAT(with("shape", nullptr), HasSubstr("has no 'shape'"));
}

/// Figures of an independent program: tests/conformance/FieldTest.cpp has the array.
TEST(PointSpread, FollowsTheLawsOfTheArray) {
  Probe probe = *loadProbe("linear");
  probe.bandwidth = 0.5, probe.transmitFNumber = 3, probe.receiveFNumber = 1.5, probe.apodization = Apodization::Hann;
  probe.elementHeight_mm = 5, probe.elevationFocus_mm = 20;
  ImagingSettings settings = settingsFor(probe);
  settings.frequency_MHz = 7.5;
  EXPECT_NEAR(axialFwhm_mm(probe, settings), 0.181, 0.001) << "0.441 * 0.2053 / 0.5";
  EXPECT_NEAR(lateralFwhm_mm(probe, settings, 20), 0.55, 0.055);
  EXPECT_NEAR(lateralFwhm_mm(probe, settings, 45), 0.67, 0.067);
  const SliceLaw slice = sliceLaw(probe, 7.5);
  EXPECT_NEAR(slice.thickness_mm(5), 2.92, 0.29);
  EXPECT_NEAR(slice.thickness_mm(45), 2.58, 0.26);
  EXPECT_NEAR(slice.at_mm, 16, 1);
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
    probe.name = "Ward 3, \"old\"", probe.maxAperture_mm = 17.25, probe.apodization = Apodization::Uniform;
    const auto file = folder / (name + ".json");
    ASSERT_TRUE(saveProbe(probe, file));
    const auto read = loadProbe(file.string());
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(textOf(*read), textOf(probe));
    EXPECT_EQ(textOf(parseProbe(textOf(probe)).value()), textOf(probe));
    EXPECT_EQ(read->name, probe.name);
    EXPECT_EQ(read->shape, probe.shape);
    EXPECT_EQ(read->apodization, probe.apodization);
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
