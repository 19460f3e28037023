#pragma once

#include "CommandLine.h"
#include "support/SmallRender.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>

namespace insonate::test {

/// `render` of the small block, to f.png in a folder of the test's own.
class RenderTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { shared_ = std::make_unique<SmallRender>(); }
  static void TearDownTestSuite() { shared_.reset(); }

  CommandResult render(const std::string& arguments) const {
    return runCommand("render " + shellWord(shared_->caseFolder()) + " --settings " + shellWord(shared_->settings()) +
                          " --out " + shellWord(out("f.png")) + " " + arguments,
                      shared_->errors());
  }
  std::string picture(const std::string& arguments) const {
    const auto result = render(arguments);
    EXPECT_EQ(result.status, 0) << arguments << '\n' << result.errors;
    return bytesOf(out("f.png"));
  }
  std::string out(const std::string& name) const { return (folder_ / name).string(); }

  inline static std::unique_ptr<SmallRender> shared_;
  TemporaryFolder folder_;
};

}  // namespace insonate::test
