#include <insonate/gpu/Memory.h>
#include <insonate/gpu/Program.h>
#include <insonate/gpu/Stopwatch.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <numeric>
#include <vector>

namespace insonate::gpu {
namespace {

class GpuCompute : public testing::Test {
 protected:
  void SetUp() override {
    auto context = Context::make();
    if (!context) GTEST_SKIP() << context.error().message;
    context_ = *context;
  }
  static Result<Program> program(const CurrentContext& current, std::string_view text) {
    return Program::make(current, "trial", std::span(&text, 1));
  }
  std::shared_ptr<Context> context_;
};

constexpr std::string_view kDoubles = R"(
layout(local_size_x = 64) in;
layout(binding = 0) buffer Values { float value[]; };
uniform int count;
void main() {
  int i = int(gl_GlobalInvocationID.x);
  if (i < count) value[i] *= 2.0;
}
)";

TEST_F(GpuCompute, AStopwatchMeasuresWorkOnTheCard) {
  const auto current = context_->use();
  const auto loop = program(*current, R"(
layout(local_size_x = 64) in;
layout(binding = 0) buffer Values { float value[]; };
uniform int count;
void main() {
  float x = float(gl_GlobalInvocationID.x);
  for (int i = 0; i < count; ++i) x = x * 0.999 + 1.0;
  value[gl_GlobalInvocationID.x] = x;
}
)");
  ASSERT_TRUE(loop) << loop.error().message;
  const auto buffer = Buffer::make(*current, 64 * 4);
  const auto watch = Stopwatch::make(*current, 3);
  ASSERT_TRUE(buffer && watch);
  buffer->bindStorage(*current, 0);
  const auto start = std::chrono::steady_clock::now();
  watch->mark(*current, 0);
  loop->setInt(*current, "count", 1'000);
  loop->run(*current, 1);
  watch->mark(*current, 1);
  loop->setInt(*current, "count", 10'000'000);
  loop->run(*current, 1);
  watch->mark(*current, 2);
  const double little_ms = watch->between_ms(*current, 0, 1), much_ms = watch->between_ms(*current, 1, 2);
  const std::chrono::duration<double, std::milli> all = std::chrono::steady_clock::now() - start;
  EXPECT_GE(little_ms, 0);
  // Mesa's software renderer notes times when it draws, not when it computes.
  if (!context_->device().software) {
    EXPECT_GT(much_ms, little_ms);
  }
  EXPECT_LE(little_ms + much_ms, all.count() + 1);
}

TEST_F(GpuCompute, RunsAndIsReadBackTwoAtATime) {
  const auto current = context_->use();
  const auto twice = program(*current, kDoubles);
  ASSERT_TRUE(twice) << twice.error().message;
  std::vector<float> values(1000);
  std::iota(values.begin(), values.end(), 0.0F);
  const auto buffer = Buffer::of(*current, std::span<const float>(values));
  ASSERT_TRUE(buffer);
  auto readBack = ReadBack::make(*current, 4000);
  ASSERT_TRUE(readBack);
  buffer->bindStorage(*current, 0);
  twice->setInt(*current, "count", 999);
  twice->run(*current, 16);
  readBack->begin(*current, *buffer, 0, 4000);
  EXPECT_FALSE(readBack->full());
  twice->run(*current, 16);
  readBack->begin(*current, *buffer, 4 * 500, 2000);
  EXPECT_TRUE(readBack->full());
  std::vector<float> first(1000), second(500);
  ASSERT_TRUE(readBack->finish(*current, std::as_writable_bytes(std::span(first))));
  ASSERT_TRUE(readBack->finish(*current, std::as_writable_bytes(std::span(second))));
  EXPECT_EQ(first[3], 6) << "as it was when asked for";
  EXPECT_EQ(first[999], 999) << "beyond the count";
  EXPECT_EQ(second[0], 2000);
  EXPECT_FALSE(readBack->full());
}

TEST_F(GpuCompute, ACompilersLogIsTold) {
  const auto current = context_->use();
  const auto wrong = program(*current, "layout(local_size_x = 1) in;\nvoid main() { colour = 1.0; }");
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("trial"), std::string::npos);
  EXPECT_NE(wrong.error().message.find("colour"), std::string::npos) << wrong.error().message;
}

struct Shared {
  int count;
  float scale;
  struct alignas(16) Row {
    float x, y, z, w;
  } row[2];
};

constexpr std::string_view kShared = R"(
layout(local_size_x = 1) in;
layout(std140, binding = 0) uniform SharedBlock { int count; float scale; vec4 row[2]; } shared_;
layout(binding = 0) buffer Values { float value[]; };
void main() { value[0] = shared_.scale * float(shared_.count) * shared_.row[1].z; }
)";

const std::vector<Field> kFields{{"SharedBlock.count", offsetof(Shared, count)},
                                 {"SharedBlock.scale", offsetof(Shared, scale)},
                                 {"SharedBlock.row[0]", offsetof(Shared, row)}};

TEST_F(GpuCompute, ABlockThatDriftsFromItsMirrorIsRefused) {
  const auto current = context_->use();
  const auto with = program(*current, kShared);
  ASSERT_TRUE(with) << with.error().message;
  const auto same = with->checkBlock(*current, "SharedBlock", kFields, sizeof(Shared));
  EXPECT_TRUE(same) << same.error().message;

  auto moved = kFields;
  std::swap(moved[0].offset, moved[1].offset);
  const auto refused = with->checkBlock(*current, "SharedBlock", moved, sizeof(Shared));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("lies at byte"), std::string::npos) << refused.error().message;

  auto more = kFields;
  more.push_back({"SharedBlock.extra", 48});
  EXPECT_FALSE(with->checkBlock(*current, "SharedBlock", more, sizeof(Shared)));
  EXPECT_FALSE(with->checkBlock(*current, "SharedBlock", std::span(kFields).first(2), sizeof(Shared)));
  EXPECT_FALSE(with->checkBlock(*current, "SharedBlock", kFields, sizeof(Shared) + 16));
  EXPECT_TRUE(with->checkBlock(*current, "Elsewhere", kFields, 0)) << "not used";
}

TEST_F(GpuCompute, UniformBlocksAndTexturesReachTheShader) {
  const auto current = context_->use();
  const auto with = program(*current, kShared);
  const Shared shared{7, 0.5F, {{}, {0, 0, 4, 0}}};
  const auto block = Buffer::of(*current, std::span(&shared, 1));
  const auto result = Buffer::make(*current, 4);
  block->bindUniform(*current, 0), result->bindStorage(*current, 0);
  with->run(*current, 1);
  float value = 0;
  result->read(*current, std::as_writable_bytes(std::span(&value, 1)));
  EXPECT_EQ(value, 14);

  const auto lookUp = program(*current, R"(
layout(local_size_x = 1) in;
layout(binding = 3) uniform sampler2D pairs;
layout(binding = 0) buffer Values { float value[]; };
void main() { value[0] = texelFetch(pairs, ivec2(1, 2), 0).y; }
)");
  ASSERT_TRUE(lookUp) << lookUp.error().message;
  std::vector<float> pairs(2 * 2 * 3);
  std::iota(pairs.begin(), pairs.end(), 0.0F);
  PairTexture texture;
  ASSERT_TRUE(texture.write(*current, 2, 3, pairs));
  pairs.back() = 0.1F;  // in place
  ASSERT_TRUE(texture.write(*current, 2, 3, pairs));
  texture.bind(*current, 3);
  lookUp->run(*current, 1);
  result->read(*current, std::as_writable_bytes(std::span(&value, 1)));
  EXPECT_EQ(value, 0.1F) << "not rounded";
}

TEST_F(GpuCompute, MoreThanTheCardHoldsIsRefused) {
  const auto current = context_->use();
  const auto huge = Buffer::make(*current, std::size_t(1) << 50);
  ASSERT_FALSE(huge);
  EXPECT_NE(huge.error().message.find("MB"), std::string::npos) << huge.error().message;
  EXPECT_FALSE(PairTexture().write(*current, 1 << 24, 1, {}));
}

}  // namespace
}  // namespace insonate::gpu
