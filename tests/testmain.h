// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <functional>
#include <memory>

#include <QObject>

namespace romanesco::test {

/// Makes a test class known to the program's main function.
void registerTest(std::function<std::unique_ptr<QObject>()> make);

template<typename Class>
struct Registration {
    Registration()
    {
        registerTest([] { return std::make_unique<Class>(); });
    }
};

}

/// Put once in each test source, after the class. The class is named as the file, in whatever case.
#define ROMANESCO_TEST(Class)                                                                                          \
    namespace {                                                                                                        \
    const romanesco::test::Registration<Class> registration;                                                           \
    }
