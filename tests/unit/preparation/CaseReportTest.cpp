#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/core/Preset.h>
#include <insonate/preparation/CaseReport.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class CaseReport : public testing::Test {
 protected:
  void SetUp() override {
    prepared_.patient = test::smallCase();
    prepared_.patient.manifest.title = "Case <b>1</b>";
    prepared_.warnings = {"The offset & scale were changed."};
    prepared_.findings = {{FindingSeverity::kWarning, "no_target", "The case has no \"target\"."}};
  }
  std::string page() {
    const auto text = readTextFile(reports_ / "index.html");
    EXPECT_TRUE(text) << text.error().message;
    return text ? *text : std::string();
  }
  const test::TemporaryFolder reports_;
  PreparedStudy prepared_;
};

TEST_F(CaseReport, ThePageShowsImagesFindingsAndWarningsAsText) {
  const auto written = writeCaseReport(prepared_, "00000000000000a1", reports_ / "00000000000000a1");
  ASSERT_TRUE(written) << written.error().message;
  EXPECT_TRUE(isReportOfCase(reports_ / "00000000000000a1"));
  ASSERT_TRUE(updateReportPage(reports_.path()));
  EXPECT_THAT(page(), HasSubstr("1 prepared, 0 not prepared"));
  EXPECT_THAT(page(), HasSubstr("Case &lt;b&gt;1&lt;/b&gt;"));
  EXPECT_THAT(page(), HasSubstr("The offset &amp; scale were changed."));
  EXPECT_THAT(page(), HasSubstr("Warning: The case has no &quot;target&quot;."));
  EXPECT_THAT(page(), HasSubstr("00000000000000a1/ultrasound1.png"));
  for (const char* image : {"slice1.png", "coronal.png", "front.png", "ultrasound1.png"})
    EXPECT_GT(fs::file_size(reports_ / "00000000000000a1" / image), 100U) << image;
}

TEST_F(CaseReport, FailuresComeFirstAndAreNoCases) {
  ASSERT_TRUE(writeCaseReport(prepared_, "00000000000000a1", reports_ / "00000000000000a1"));
  ASSERT_TRUE(writeFailureReport("00000000000000b2", "No <body> was found.", reports_ / "00000000000000b2"));
  EXPECT_FALSE(isReportOfCase(reports_ / "00000000000000b2"));
  EXPECT_FALSE(isReportOfCase(reports_ / "missing"));
  ASSERT_TRUE(updateReportPage(reports_.path()));
  EXPECT_THAT(page(), HasSubstr("1 prepared, 1 not prepared"));
  EXPECT_THAT(page(), HasSubstr("No &lt;body&gt; was found."));
  EXPECT_LT(page().find("00000000000000b2"), page().find("00000000000000a1"));
}

TEST_F(CaseReport, ACaseReplacesTheReportOfAFailure) {
  const fs::path folder = reports_ / "00000000000000a1";
  ASSERT_TRUE(writeFailureReport("00000000000000a1", "The disk was full.", folder));
  ASSERT_TRUE(writeCaseReport(prepared_, "00000000000000a1", folder));
  ASSERT_TRUE(updateReportPage(reports_.path()));
  EXPECT_TRUE(isReportOfCase(folder));
  EXPECT_THAT(page(), Not(HasSubstr("The disk was full.")));
}

}  // namespace
}  // namespace insonate
