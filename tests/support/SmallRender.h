#pragma once

#include "support/SmallCase.h"
#include "support/TestData.h"

#include <fstream>
#include <string>

namespace insonate::test {

/// A folder with the small case, and settings with which its images come quickly.
class SmallRender {
 public:
  SmallRender() {
    const auto written = writeCase(smallCase(), caseFolder());
    EXPECT_TRUE(written) << written.error().message;
    std::ofstream(settings())
        << R"({"scanlines": 32, "samples": 128, "elevationPlanes": 1, "looks": 1, "width": 96, "height": 80,
               "depth_mm": 30})";
  }
  std::filesystem::path caseFolder() const { return folder_ / "case"; }
  std::string settings() const { return folder_ / "small.json"; }
  /// File with the standard error of runs.
  std::string errors() const { return folder_ / "stderr.txt"; }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  TemporaryFolder folder_;
};

}  // namespace insonate::test
