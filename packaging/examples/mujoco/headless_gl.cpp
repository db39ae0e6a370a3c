// SPDX-License-Identifier: Apache-2.0
#include "headless_gl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <stdexcept>

namespace mujoco_example {

namespace {

/// Mesa's displays without a surface; where there are none, what the system takes for its display.
EGLDisplay openDisplay() {
    const auto platformDisplay =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    EGLDisplay display = EGL_NO_DISPLAY;
    if (platformDisplay != nullptr) {
        display = platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    }
    return display != EGL_NO_DISPLAY ? display : eglGetDisplay(EGL_DEFAULT_DISPLAY);
}

} // namespace

HeadlessGl::HeadlessGl() {
    m_display = openDisplay();
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint configs = 0;
    const bool isReady = eglInitialize(m_display, nullptr, nullptr) == EGL_TRUE &&
                         eglChooseConfig(m_display, wanted, &config, 1, &configs) == EGL_TRUE &&
                         configs > 0 && eglBindAPI(EGL_OPENGL_API) == EGL_TRUE;
    m_context = isReady ? eglCreateContext(m_display, config, EGL_NO_CONTEXT, nullptr) : EGL_NO_CONTEXT;
    if (m_context == EGL_NO_CONTEXT ||
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context) != EGL_TRUE) {
        throw std::runtime_error(
            "EGL has no OpenGL context without a display; on Debian, install libgl1-mesa-dri.");
    }
}

HeadlessGl::~HeadlessGl() {
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
    eglTerminate(m_display);
}

} // namespace mujoco_example
