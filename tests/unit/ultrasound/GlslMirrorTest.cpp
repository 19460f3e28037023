#include "glsl/Device.h"
#include "glsl/FrameBlock.h"
#include "model/Scatterers.h"

#include <insonate/core/Hash.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <vector>

namespace insonate::glsl {
namespace {

/// Constants and functions that shaders and C++ must have alike.
class GlslMirror : public testing::Test {
 protected:
  void SetUp() override {
    auto context = gpu::Context::make();
    if (!context) GTEST_SKIP() << context.error().message;
    context_ = *context;
  }

  /// Results of a program of these parts, as whole numbers.
  std::vector<std::uint32_t> results(const std::string& parts, std::string_view main, int count) {
    const auto current = context_->use();
    const std::string text = constantsText() + parts +
                             "layout(local_size_x = 1) in;\n"
                             "layout(binding = 0) buffer Results { uint result[]; };\n" +
                             std::string(main);
    const std::string_view view = text;
    const auto program = gpu::Program::make(*current, "trial", std::span(&view, 1));
    if (!program) {
      ADD_FAILURE() << program.error().message;
      return std::vector<std::uint32_t>(count);
    }
    std::vector<std::uint32_t> numbers(count);
    const auto buffer = gpu::Buffer::of(*current, std::span<const std::uint32_t>(numbers));
    buffer->bindStorage(*current, 0);
    program->run(*current, count);
    buffer->read(*current, std::as_writable_bytes(std::span(numbers)));
    return numbers;
  }

  std::shared_ptr<gpu::Context> context_;
};

TEST_F(GlslMirror, HashesAreTheSameWholeNumbers) {
  constexpr int kCount = 500;
  const auto ofNodes = results(shaderText("hash"), R"(
void main() {
  int n = int(gl_WorkGroupID.x);
  result[n] = hashNode(ivec3(n - 250, 7919 * n - 1000000, -n * n), 0x9e3779b9u + uint(n));
}
)",
                               kCount);
  const auto ofNumbers =
      results(shaderText("hash"),
              "void main() { result[gl_WorkGroupID.x] = hash32(gl_WorkGroupID.x * 2654435761u); }\n", kCount);
  for (int n = 0; n < kCount; ++n) {
    EXPECT_EQ(ofNodes[n], hashNode(n - 250, 7919 * n - 1000000, -n * n, 0x9e3779b9U + std::uint32_t(n)));
    EXPECT_EQ(ofNumbers[n], hash32(std::uint32_t(n) * 2654435761U));
  }
}

/// shaders/echoes.comp counts the fields of a hash, C++ lists where they begin.
TEST(GlslRecords, FieldsOfAHashBeginWhereTheyDoInCpp) {
  for (int c = 0; c < 6; ++c) EXPECT_EQ(5 * c + (c >= 3 ? 1 : 0), kScattererShift[c]);
}

TEST_F(GlslMirror, BlocksOfAllShadersAreThoseOfCpp) {
  const auto device = Device::shared();
  ASSERT_TRUE(device) << device.error().message;
  const auto current = (*device)->context().use();
  for (int stage = 0; stage < int(Stage::kCount); ++stage) {
    const gpu::Program& program = (*device)->program(Stage(stage));
    const auto frame = program.checkBlock(*current, "FrameBlock", frameFields(), sizeof(FrameBlock));
    EXPECT_TRUE(frame) << frame.error().message;
    const auto thesis = program.checkBlock(*current, "ThesisBlock", thesisFields(), sizeof(ThesisBlock));
    EXPECT_TRUE(thesis) << thesis.error().message;
    const auto color = program.checkBlock(*current, "ColorBlock", colorFields(), sizeof(ColorBlock));
    EXPECT_TRUE(color) << color.error().message;
  }
}

TEST_F(GlslMirror, ABlockThatDriftsIsTold) {
  const auto device = Device::shared();
  const auto current = (*device)->context().use();
  const gpu::Program& program = (*device)->program(Stage::Tissue);
  auto fields = frameFields();
  const auto lines = std::ranges::find(fields, "FrameBlock.lines", &gpu::Field::name);
  const auto gates = std::ranges::find(fields, "FrameBlock.gates", &gpu::Field::name);
  std::swap(lines->offset, gates->offset);
  EXPECT_FALSE(program.checkBlock(*current, "FrameBlock", fields, sizeof(FrameBlock)));
  std::swap(lines->offset, gates->offset);
  const auto tile = std::ranges::find(fields, "FrameBlock.channel[0].tile", &gpu::Field::name);
  tile->offset += 4;
  const auto refused = program.checkBlock(*current, "FrameBlock", fields, sizeof(FrameBlock));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("channel[0].tile"), std::string::npos) << refused.error().message;
}

/// Records between stages, whose sizes C++ allocates by.
TEST(GlslRecords, HaveTheSizesThatAreAllocated) {
  const std::string text = shaderText("records");
  const auto numbersIn = [&](const std::string& name) {
    const auto begin = text.find("struct " + name), end = text.find("};", begin);
    std::string body = text.substr(begin, end - begin), line;
    int numbers = 0;
    std::istringstream lines(body);
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      line = line.substr(0, line.find("//"));
      if (line.find(';') == std::string::npos) continue;
      numbers += 1 + int(std::ranges::count(line, ','));
      if (const auto array = line.find('['); array != std::string::npos)
        numbers += std::stoi(line.substr(array + 1)) - 1;
    }
    return std::size_t(4) * numbers;
  };
  EXPECT_EQ(numbersIn("Node"), kNodeBytes);
  EXPECT_EQ(numbersIn("Cell"), kCellBytes);
  EXPECT_EQ(numbersIn("GateSample"), kSampleBytes);
  EXPECT_EQ(numbersIn("Crossing"), kCrossingBytes);
}

}  // namespace
}  // namespace insonate::glsl
