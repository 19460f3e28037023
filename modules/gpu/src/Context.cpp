#include <insonate/gpu/Context.h>

// Excludes X11's macros from EGL.
#define EGL_NO_X11
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate::gpu {
namespace {

constexpr const char* kNone = "OpenGL cannot run without a window here: ";
constexpr const char* kNoCard = "No suitable graphics card was found: ";

bool isSoftware(std::string_view renderer) {
  for (const char* name : {"llvmpipe", "softpipe", "SWR", "SwiftShader", "Software", "swrast"})
    if (renderer.find(name) != std::string_view::npos) return true;
  return false;
}

bool has(const char* extensions, std::string_view name) {
  return extensions && std::string_view(extensions).find(name) != std::string_view::npos;
}

/// Display of a device that EGL lists; else Mesa without a surface; else the default display.
std::vector<EGLDisplay> displays(bool hardware) {
  std::vector<EGLDisplay> found;
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const auto platformDisplay =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  const auto queryDevices = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  const auto deviceString =
      reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
  if (platformDisplay && queryDevices && has(client, "EGL_EXT_platform_device")) {
    std::array<EGLDeviceEXT, 16> devices;
    EGLint count = 0;
    if (queryDevices(EGLint(devices.size()), devices.data(), &count))
      for (int d = 0; d < count; ++d) {
        const char* about = deviceString ? deviceString(devices[d], EGL_EXTENSIONS) : nullptr;
        if (hardware && has(about, "EGL_MESA_device_software")) continue;
        found.push_back(platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[d], nullptr));
      }
    // EGL lists all devices that exist.
    if (hardware) return found;
  }
  if (platformDisplay && has(client, "EGL_MESA_platform_surfaceless"))
    found.push_back(platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  found.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
  std::erase(found, EGL_NO_DISPLAY);
  return found;
}

EGLContext contextOn(EGLDisplay display, const Requirements& need) {
  const EGLint configWish[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, 0, EGL_NONE};
  EGLConfig config{};
  EGLint count = 0;
  if (!eglChooseConfig(display, configWish, &config, 1, &count) || count == 0) return EGL_NO_CONTEXT;
  const EGLint wish[] = {EGL_CONTEXT_MAJOR_VERSION,
                         need.major,
                         EGL_CONTEXT_MINOR_VERSION,
                         need.minor,
                         EGL_CONTEXT_OPENGL_PROFILE_MASK,
                         EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                         EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                         EGL_LOSE_CONTEXT_ON_RESET,
                         EGL_NONE};
  if (const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, wish)) return context;
  // Some drivers do not report resets.
  std::array<EGLint, 7> less{};
  std::copy_n(wish, 6, less.begin());
  less[6] = EGL_NONE;
  return eglCreateContext(display, config, EGL_NO_CONTEXT, less.data());
}

std::string text(unsigned name) {
  const auto* string = reinterpret_cast<const char*>(glGetString(name));
  return string ? string : "";
}

int limit(unsigned name) {
  int value = 0;
  glGetIntegerv(name, &value);
  return value;
}

Result<DeviceInfo> inspect(const Requirements& need) {
  DeviceInfo device{text(GL_RENDERER), text(GL_VENDOR), text(GL_VERSION), false};
  device.software = isSoftware(device.renderer);
  const auto lacks = [&](const std::string& what) { return fail(device.renderer + " lacks " + what + "."); };
  if (epoxy_gl_version() < 10 * need.major + need.minor)
    return lacks("OpenGL " + std::to_string(need.major) + "." + std::to_string(need.minor));
  if (need.hardware && device.software) return fail(device.renderer + " is a software renderer.");
  if (limit(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS) < need.storageBuffers)
    return lacks(std::to_string(need.storageBuffers) + " storage buffers in a compute shader");
  if (limit(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS) < need.workgroupThreads)
    return lacks("workgroups of " + std::to_string(need.workgroupThreads) + " threads");
  return device;
}

}  // namespace

struct Context::Handles {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  bool tellsOfResets = false;
};

struct CurrentContext::Before {
  EGLenum api = EGL_OPENGL_ES_API;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLSurface draw = EGL_NO_SURFACE, read = EGL_NO_SURFACE;
  EGLContext context = EGL_NO_CONTEXT;

  Before()
      : api(eglQueryAPI()),
        display(eglGetCurrentDisplay()),
        draw(eglGetCurrentSurface(EGL_DRAW)),
        read(eglGetCurrentSurface(EGL_READ)),
        context(eglGetCurrentContext()) {}
};

Context::Context(std::unique_ptr<Handles> handles) : handles_(std::move(handles)) {}

Context::~Context() {
  // The display is not terminated: other code of this process may use it, and EGL does not count users.
  eglDestroyContext(handles_->display, handles_->context);
}

Result<std::shared_ptr<Context>> Context::make(const Requirements& requirements) {
  const std::string none = requirements.hardware ? kNoCard : kNone;
  if (!epoxy_has_egl()) return fail(none + "libEGL is not installed.");
  std::shared_ptr<Context> best;
  std::string why = requirements.hardware ? "EGL lists no device." : "EGL finds no device.";
  for (const EGLDisplay display : displays(requirements.hardware)) {
    EGLint major = 0, minor = 0;
    if (!eglInitialize(display, &major, &minor)) continue;
    if (!epoxy_has_egl_extension(display, "EGL_KHR_surfaceless_context")) continue;
    const EGLenum api = eglQueryAPI();
    eglBindAPI(EGL_OPENGL_API);
    auto handles = std::make_unique<Handles>();
    handles->display = display;
    handles->context = contextOn(display, requirements);
    eglBindAPI(api);
    if (handles->context == EGL_NO_CONTEXT) {
      if (!best)
        why = "no driver offers OpenGL " + std::to_string(requirements.major) + "." +
              std::to_string(requirements.minor) + "; a newer driver may do so.";
      continue;
    }
    std::shared_ptr<Context> context(new Context(std::move(handles)));
    auto current = context->use();
    auto device = current ? inspect(requirements) : tl::unexpected(current.error());
    if (!device) {
      why = device.error().message;
      continue;
    }
    context->handles_->tellsOfResets = epoxy_gl_version() >= 45 || epoxy_has_gl_extension("GL_KHR_robustness");
    context->device_ = std::move(*device);
    if (!best || !context->device_.software) best = context;
    if (!best->device_.software) break;
  }
  if (!best) return fail(none + why);
  return best;
}

Result<CurrentContext> Context::use() {
  std::unique_lock lock(mutex_);
  if (lost_) return fail("The graphics card was reset and lost its data.");
  auto before = std::make_unique<CurrentContext::Before>();
  eglBindAPI(EGL_OPENGL_API);
  if (!eglMakeCurrent(handles_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, handles_->context)) {
    eglBindAPI(before->api);
    return fail("OpenGL cannot be used on this thread, because the thread already draws with another OpenGL context.");
  }
  return CurrentContext(shared_from_this(), std::move(lock), std::move(before));
}

CurrentContext::CurrentContext(std::shared_ptr<Context> context, std::unique_lock<std::recursive_mutex> lock,
                               std::unique_ptr<Before> before)
    : context_(std::move(context)), lock_(std::move(lock)), before_(std::move(before)) {}

CurrentContext::CurrentContext(CurrentContext&& other) noexcept = default;

CurrentContext::~CurrentContext() {
  if (!before_) return;
  const bool any = before_->context != EGL_NO_CONTEXT;
  eglMakeCurrent(any ? before_->display : context_->handles_->display, before_->draw, before_->read, before_->context);
  eglBindAPI(before_->api);
}

Result<void> CurrentContext::check() const {
  if (context_->handles_->tellsOfResets && glGetGraphicsResetStatus() != GL_NO_ERROR) context_->lost_ = true;
  if (context_->lost_) return fail("The graphics card was reset and lost its data.");
  const unsigned error = glGetError();
  if (error == GL_NO_ERROR) return {};
  while (glGetError() != GL_NO_ERROR) {
  }
  if (error == GL_OUT_OF_MEMORY) return fail("The graphics card has no memory left.");
  return fail("The graphics driver refused a call (OpenGL error " + std::to_string(error) + ").");
}

}  // namespace insonate::gpu
