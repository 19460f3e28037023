#include <insonate/gpu/Context.h>
#include <insonate/gpu/Memory.h>

#define EGL_NO_X11
#include <epoxy/egl.h>
#include <gtest/gtest.h>

#include <thread>

namespace insonate::gpu {
namespace {

/// A context, or a visible skip.
#define NEEDS_GPU(context)        \
  auto context = Context::make(); \
  if (!context) GTEST_SKIP() << (context).error().message

TEST(GpuContext, NamesItsDevice) {
  NEEDS_GPU(context);
  EXPECT_FALSE((*context)->device().renderer.empty());
  EXPECT_FALSE((*context)->device().version.empty());
  RecordProperty("renderer", (*context)->device().renderer);
  if ((*context)->device().renderer.find("llvmpipe") != std::string::npos) {
    EXPECT_TRUE((*context)->device().software);
  }
}

TEST(GpuContext, IsCurrentOnlyWhileUsed) {
  NEEDS_GPU(context);
  ASSERT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
  {
    const auto current = (*context)->use();
    ASSERT_TRUE(current);
    EXPECT_NE(eglGetCurrentContext(), EGL_NO_CONTEXT);
  }
  EXPECT_EQ(eglGetCurrentContext(), EGL_NO_CONTEXT);
}

TEST(GpuContext, LeavesAnothersContextAsItWas) {
  NEEDS_GPU(other);
  NEEDS_GPU(context);
  const auto others = (*other)->use();
  const EGLContext before = eglGetCurrentContext();
  const EGLenum api = eglQueryAPI();
  {
    const auto current = (*context)->use();
    ASSERT_TRUE(current);
    EXPECT_NE(eglGetCurrentContext(), before);
    ASSERT_TRUE(Buffer::make(*current, 64));
  }
  EXPECT_EQ(eglGetCurrentContext(), before);
  EXPECT_EQ(eglQueryAPI(), api);
}

TEST(GpuContext, GoesFromThreadToThread) {
  NEEDS_GPU(context);
  const auto once = [&] {
    const auto current = (*context)->use();
    ASSERT_TRUE(current);
    const auto buffer = Buffer::make(*current, 1024);
    EXPECT_TRUE(buffer);
    EXPECT_TRUE(current->check());
  };
  once();
  std::thread first(once), second(once);
  first.join(), second.join();
}

TEST(GpuContext, SaysWhatADriverLacks) {
  NEEDS_GPU(context);
  const auto version = Context::make({.major = 9, .minor = 1});
  ASSERT_FALSE(version);
  EXPECT_NE(version.error().message.find("OpenGL 9.1"), std::string::npos) << version.error().message;
  const auto buffers = Context::make({.storageBuffers = 1 << 20});
  ASSERT_FALSE(buffers);
  EXPECT_NE(buffers.error().message.find("storage buffers"), std::string::npos) << buffers.error().message;
  const auto threads = Context::make({.workgroupThreads = 1 << 24});
  ASSERT_FALSE(threads);
  EXPECT_NE(threads.error().message.find("threads"), std::string::npos) << threads.error().message;
}

TEST(GpuContext, OnRequestHardwareOnly) {
  NEEDS_GPU(context);
  const auto hardware = Context::make({.hardware = true});
  EXPECT_EQ(bool(hardware), !(*context)->device().software) << "hardware is taken first";
  if (!hardware) {
    EXPECT_FALSE(hardware.error().message.empty());
  } else {
    EXPECT_FALSE((*hardware)->device().software);
  }
}

TEST(GpuContext, OnceLostStaysLost) {
  NEEDS_GPU(context);
  auto buffer = Buffer::make(*(*context)->use(), 64);
  ASSERT_TRUE(buffer);
  (*context)->simulateLoss();
  const auto current = (*context)->use();
  ASSERT_FALSE(current);
  EXPECT_NE(current.error().message.find("reset"), std::string::npos);
  EXPECT_TRUE(Context::make()) << "a new one works";
}

TEST(GpuContext, TellsOfALossWhileInUse) {
  NEEDS_GPU(context);
  const auto current = (*context)->use();
  ASSERT_TRUE(current->check());
  (*context)->simulateLoss();
  EXPECT_FALSE(current->check());
}

}  // namespace
}  // namespace insonate::gpu
