// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "eglcontext.h"

#include <array>
#include <cstring>
#include <vector>

#include <epoxy/egl.h>

namespace romanesco {

namespace {

bool hasExtension(EGLDisplay display, const char *name)
{
    const char *all = eglQueryString(display, EGL_EXTENSIONS);
    return all && std::strstr(all, name);
}

bool isCard(EGLDeviceEXT device)
{
    const char *all = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    return all && (std::strstr(all, "EGL_EXT_device_drm") || std::strstr(all, "EGL_NV_device_cuda"));
}

/// Displays to try, the most promising first: cards, then Mesa without a surface, then what EGL takes for its default.
std::vector<EGLDisplay> candidates()
{
    std::vector<EGLDisplay> displays;
    if (hasExtension(EGL_NO_DISPLAY, "EGL_EXT_platform_device")
        && hasExtension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration")) {
        std::array<EGLDeviceEXT, 16> devices;
        EGLint count = 0;
        eglQueryDevicesEXT(static_cast<EGLint>(devices.size()), devices.data(), &count);
        for (EGLint i = 0; i < count; ++i) {
            const EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
            if (isCard(device)) {
                displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr));
            }
        }
    }
    if (hasExtension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless")) {
        displays.push_back(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
    }
    displays.push_back(eglGetDisplay(EGL_DEFAULT_DISPLAY));
    return displays;
}

EGLContext currentContext(EGLDisplay display)
{
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_API)) {
        return EGL_NO_CONTEXT;
    }
    const bool needsNothing =
        hasExtension(display, "EGL_KHR_no_config_context") && hasExtension(display, "EGL_KHR_surfaceless_context");
    if (!needsNothing) {
        return EGL_NO_CONTEXT;
    }
    // Such as tells when the driver was reset, where there is one.
    for (const EGLint notification : {EGL_LOSE_CONTEXT_ON_RESET, EGL_NO_RESET_NOTIFICATION}) {
        const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                     4,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     5,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                                     notification,
                                     EGL_NONE};
        const EGLContext context = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
        if (context != EGL_NO_CONTEXT && eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
            return context;
        }
        if (context != EGL_NO_CONTEXT) {
            eglDestroyContext(display, context);
        }
    }
    return EGL_NO_CONTEXT;
}

}

std::expected<std::unique_ptr<EglContext>, std::string> EglContext::create()
{
    for (const EGLDisplay display : candidates()) {
        const EGLContext context = currentContext(display);
        if (context != EGL_NO_CONTEXT) {
            auto made = std::unique_ptr<EglContext>(new EglContext);
            made->m_display = display;
            made->m_context = context;
            return made;
        }
    }
    return std::unexpected(std::string("Drawing needs OpenGL 4.5 through EGL, and no driver here offers it."));
}

EglContext::~EglContext()
{
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
}

}
