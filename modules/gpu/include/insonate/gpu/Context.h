#pragma once

#include <insonate/core/Result.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

/// These classes compute on a graphics card through OpenGL, without a window. No OpenGL or EGL type is visible outside
/// this module.
namespace insonate::gpu {

/// Capabilities that a driver must offer; the defaults are what the shaders of this project need.
struct Requirements {
  int major = 4, minor = 3;  ///< minimum OpenGL version, core profile
  int storageBuffers = 8;    ///< storage buffers that one compute shader can access
  int workgroupThreads = 1024;
  bool hardware = false;  ///< true: software renderers are refused
};

struct DeviceInfo {
  std::string renderer, vendor, version;
  bool software = false;  ///< true: the CPU computes (Mesa's llvmpipe, SwiftShader and similar drivers)
};

class CurrentContext;

/// An OpenGL context on the first hardware device that meets the requirements, else on a software renderer. Buffers and
/// programs that were made with a context keep the context alive. Any thread may use a context, but only one thread at
/// a time (see CurrentContext).
class Context : public std::enable_shared_from_this<Context> {
 public:
  /// Makes a context. Fails if there is no EGL, no device, or no driver that meets the requirements; the error says
  /// which is missing.
  static Result<std::shared_ptr<Context>> make(const Requirements& requirements = {});
  ~Context();

  const DeviceInfo& device() const { return device_; }

  /// Makes the context current on the calling thread; waits while another thread uses it. Fails if the context is lost,
  /// or if the thread has another current OpenGL context that cannot be set aside (GLX).
  Result<CurrentContext> use();

  /// Tells whether use() or CurrentContext::check() has found that the context, with all its contents, was lost, e.g.
  /// by a reset of the card.
  bool lost() const { return lost_; }
  /// Simulates a reset of the card, for tests: use() fails from now on.
  void simulateLoss() { lost_ = true; }

 private:
  friend class CurrentContext;
  struct Handles;
  explicit Context(std::unique_ptr<Handles> handles);

  std::unique_ptr<Handles> handles_;
  DeviceInfo device_;
  std::recursive_mutex mutex_;
  std::atomic<bool> lost_ = false;
};

/// Keeps the context current on this thread, and on no other, during the object's lifetime; afterwards the previous
/// context is current again. Every function that uses the card takes a CurrentContext, so that none can be called
/// without a current context.
class CurrentContext {
 public:
  ~CurrentContext();
  CurrentContext(CurrentContext&& other) noexcept;
  CurrentContext& operator=(CurrentContext&&) = delete;

  const std::shared_ptr<Context>& context() const { return context_; }

  /// Fails with a sentence if an error has occurred since the last check: an OpenGL error, exhausted memory, or a reset
  /// of the card (after which the context is lost). Does not wait for the card.
  Result<void> check() const;

 private:
  friend class Context;
  struct Before;
  CurrentContext(std::shared_ptr<Context> context, std::unique_lock<std::recursive_mutex> lock,
                 std::unique_ptr<Before> before);

  std::shared_ptr<Context> context_;
  std::unique_lock<std::recursive_mutex> lock_;
  std::unique_ptr<Before> before_;
};

}  // namespace insonate::gpu
