#include "render/gl/egl_context.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>
#include <fmt/core.h>

#include <array>

#include "core/base/error.h"
#include "render/gl/gl_info.h"

namespace swaplight {
namespace {

[[noreturn]] void fail(const char* what) {
  throw ResourceError(
      fmt::format("no OpenGL without a window here: {} (EGL error 0x{:04x}). Install a driver with "
                  "EGL, such as Debian's libegl1 and libgl1-mesa-dri",
                  what, eglGetError()));
}

EGLDisplay openDisplay() {
  // Mesa draws without any surface; other vendors offer their cards as devices.
  EGLDisplay display = EGL_NO_DISPLAY;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
  if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")) {
    std::array<EGLDeviceEXT, 8> devices{};
    EGLint count = 0;
    eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
    for (EGLint i = 0; i < count; ++i) {
      display = eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, devices[static_cast<size_t>(i)], nullptr);
      if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    }
  }
  fail("EGL offers neither the surfaceless nor the device platform");
}

}  // namespace

EglContext::EglContext() {
  m_display = openDisplay();
  if (!eglBindAPI(EGL_OPENGL_API)) fail("EGL has no desktop OpenGL");
  constexpr std::array<EGLint, 5> kConfigWish{EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                                              EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint configs = 0;
  if (!eglChooseConfig(m_display, kConfigWish.data(), &config, 1, &configs) || configs == 0)
    config = nullptr;  // surfaceless contexts need none
#ifdef NDEBUG
  constexpr EGLint kDebug = EGL_FALSE;
#else
  constexpr EGLint kDebug = EGL_TRUE;
#endif
  constexpr std::array<EGLint, 9> kWish{EGL_CONTEXT_MAJOR_VERSION,
                                        4,
                                        EGL_CONTEXT_MINOR_VERSION,
                                        1,
                                        EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                        EGL_CONTEXT_OPENGL_DEBUG,
                                        kDebug,
                                        EGL_NONE};
  m_context = eglCreateContext(m_display, config, EGL_NO_CONTEXT, kWish.data());
  if (m_context == EGL_NO_CONTEXT) fail("the driver makes no OpenGL 4.1 core context");
  if (!eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
    fail("the driver cannot draw without a surface");
  installGlDebugOutput();
}

EglContext::~EglContext() {
  eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(m_display, m_context);
}

}  // namespace swaplight
