// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "screen.h"

#include <cstdlib>
#include <print>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

namespace romanesco::bench {

struct Screen::Connection {
    Display *display = nullptr;
};

Screen::Screen()
    : m_connection(std::make_unique<Connection>(Connection{XOpenDisplay(nullptr)}))
{
    if (!m_connection->display) {
        std::println(stderr, "there is no display; packaging/withdisplay makes one");
        std::exit(EXIT_FAILURE);
    }
}

Screen::~Screen()
{
    XCloseDisplay(m_connection->display);
}

Screen::Look Screen::look() const
{
    constexpr int step = 7;
    constexpr int enough = 400;
    Display *display = m_connection->display;
    const int screen = DefaultScreen(display);
    const int width = DisplayWidth(display, screen);
    const int height = DisplayHeight(display, screen);
    XImage *image = XGetImage(display, RootWindow(display, screen), 0, 0, static_cast<unsigned>(width),
                              static_cast<unsigned>(height), AllPlanes, ZPixmap);
    Look look;
    if (!image) {
        return look;
    }
    int sandy = 0;
    for (int y = 0; y < height; y += step) {
        for (int x = 0; x < width; x += step) {
            const unsigned long pixel = XGetPixel(image, x, y);
            const auto red = (pixel >> 16) & 0xff;
            const auto green = (pixel >> 8) & 0xff;
            const auto blue = pixel & 0xff;
            look.isPainted = look.isPainted || (pixel & 0xffffff) != 0;
            sandy += red > 150 && green > 130 && green < red && blue + 20 < green ? 1 : 0;
        }
    }
    XDestroyImage(image);
    look.hasFractal = sandy >= enough;
    return look;
}

}
