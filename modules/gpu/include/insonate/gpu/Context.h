#pragma once

#include <insonate/core/Result.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

/// Computing on a graphics card through OpenGL, without a window. No type of OpenGL or EGL leaves this module.
namespace insonate::gpu {

/// Capabilities that a driver must offer; the defaults are what the shaders of this project need.
struct Requirements {
  int major = 4, minor = 3;  ///< of OpenGL, core profile
  int storageBuffers = 8;    ///< that one compute shader may see
  int workgroupThreads = 256;
  bool hardware = false;  ///< a software renderer will not do, and is not even loaded where EGL tells them apart
};

struct DeviceInfo {
  std::string renderer, vendor, version;
  bool software = false;  ///< the "card" is the processor: Mesa's llvmpipe, SwiftShader and the like
};

class Current;

/// An OpenGL context of its own, on the first hardware device that serves, else on a software renderer. Objects made
/// with it keep it alive. May be handed from thread to thread; used by one at a time (see Current).
class Context : public std::enable_shared_from_this<Context> {
 public:
  /// Fails where no EGL, no device or no driver with these features is there; the sentence says which.
  static Result<std::shared_ptr<Context>> make(const Requirements& requirements = {});
  ~Context();

  const DeviceInfo& device() const { return device_; }

  /// Makes it current on the calling thread; waits while another thread uses it. Fails when the context is lost, or
  /// where the thread draws with an OpenGL that cannot be put aside (GLX).
  Result<Current> use();

  /// Tells whether use() or Current::check() found the context lost; its contents are gone.
  bool lost() const { return lost_; }
  /// Simulates a reset of the card: from now on use() fails. For tests.
  void simulateLoss() { lost_ = true; }

 private:
  friend class Current;
  struct Handles;
  explicit Context(std::unique_ptr<Handles> handles);

  std::unique_ptr<Handles> handles_;
  DeviceInfo device_;
  std::recursive_mutex mutex_;
  std::atomic<bool> lost_ = false;
};

/// Makes the context current on this thread, and on no other, while the object lives; then the former context is
/// current again. Every function that uses the card takes one, so that none can be called without it.
class Current {
 public:
  ~Current();
  Current(Current&& other) noexcept;
  Current& operator=(Current&&) = delete;

  const std::shared_ptr<Context>& context() const { return context_; }

  /// The sentence of what went wrong since the last check: an error, memory run out, the card reset (after which the
  /// context is lost). Waits for nothing.
  Result<void> check() const;

 private:
  friend class Context;
  struct Before;
  Current(std::shared_ptr<Context> context, std::unique_lock<std::recursive_mutex> lock,
          std::unique_ptr<Before> before);

  std::shared_ptr<Context> context_;
  std::unique_lock<std::recursive_mutex> lock_;
  std::unique_ptr<Before> before_;
};

}  // namespace insonate::gpu
