#include "color/ColorRegistry.h"
#include "conformance/glsl/CloseAgreement.h"
#include "conformance/glsl/CompactColor.h"
#include "glsl/Device.h"
#include "glsl/GlslEngine.h"

#include <insonate/embedded/shaders.h>

#include <cstdlib>
#include <iostream>
#include <sstream>

namespace insonate::test {
namespace {

std::vector<std::string> linesOf(std::string_view text) {
  std::vector<std::string> lines;
  std::istringstream in{std::string(text)};
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string without(const std::vector<std::string>& lines, std::size_t gone) {
  std::string text;
  for (std::size_t n = 0; n < lines.size(); ++n)
    if (n != gone) text += lines[n] + '\n';
  return text;
}

/// Tells whether a line has a meaning for the compiler.
bool counts(const std::string& line) {
  const auto first = line.find_first_not_of(" \t");
  return first != std::string::npos && line.compare(first, 2, "//") != 0;
}

class ShaderLines : public testing::Test {
 protected:
  void SetUp() override {
    const auto device = glsl::Device::shared();
    if (!device) GTEST_SKIP() << device.error().message;
    device_ = *device;
    for (const CompactCase& c : cases_)
      truths_.push_back(renderWith("reference", c.probe, c.settings, *c.scene, c.pose, c.displacement, c.needle));
    const auto reference = makeColorDoppler("reference");
    for (const CompactColor& c : colors_) colorTruths_.push_back(colorWith(**reference, c));
  }

  /// Tells whether any test would fail with these shaders.
  bool isTold(const glsl::EditedFile& edited) {
    const auto device = device_->with(edited);
    if (!device) return true;  // the engine cannot be made
    // Shaders of color change no image.
    if (edited.name.starts_with("color")) return isToldByColor(*device);
    const auto engine = glsl::makeEngineOn(*device);
    // The test that found the last line goes first: neighboring lines mostly fail alike.
    for (std::size_t n = 0; n < cases_.size(); ++n) {
      const std::size_t i = (last_ + n) % cases_.size();
      const CompactCase& c = cases_[i];
      EnvelopeFrame frame;
      engine->prepare(c.probe, c.settings);
      engine->render(*c.scene, c.pose, c.displacement, c.needle ? &*c.needle : nullptr, frame);
      if (engine->name() == "glsl" && errorOf(frame, truths_[i]) < kCloseError) continue;
      last_ = i;
      return true;
    }
    return false;
  }

  bool isToldByColor(const std::shared_ptr<const glsl::Device>& device) {
    const auto doppler = glsl::makeColorOn(device);
    for (std::size_t n = 0; n < colors_.size(); ++n) {
      const std::size_t i = (lastColor_ + n) % colors_.size();
      const double error = colorErrorOf(colorWith(*doppler, colors_[i]), colorTruths_[i]);
      if (doppler->name() == "glsl" && error < kCloseError) continue;
      lastColor_ = i;
      return true;
    }
    return false;
  }

  const std::vector<CompactCase> cases_ = compactCases();
  const std::vector<CompactColor> colors_ = compactColors();
  std::vector<ColorFrame> colorTruths_;
  std::vector<EnvelopeFrame> truths_;
  std::shared_ptr<const glsl::Device> device_;
  std::size_t last_ = 0, lastColor_ = 0;
};

/// No line of a shader can go without a test that fails. INSONATE_SHADER names one file to look at.
TEST_F(ShaderLines, AreAllNeeded) {
  const char* only = std::getenv("INSONATE_SHADER");
  int removed = 0;
  for (const auto& file : embedded::shaders::files()) {
    if (only && file.name != only) continue;
    const std::vector<std::string> lines = linesOf(file.text);
    for (std::size_t n = 0; n < lines.size(); ++n) {
      if (!counts(lines[n])) continue;
      ++removed;
      EXPECT_TRUE(isTold({std::string(file.name), without(lines, n)}))
          << file.name << ":" << n + 1 << " can go: " << lines[n];
    }
    std::cout << file.name << " done, " << removed << " lines so far" << std::endl;
  }
  EXPECT_FALSE(isTold({})) << "as they are";
  EXPECT_FALSE(isToldByColor(device_)) << "color as it is";
  RecordProperty("lines_removed", removed);
}

}  // namespace
}  // namespace insonate::test
