// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <functional>
#include <memory>

#include <QObject>

namespace romanesco::test {

/// What a test begins its random numbers with: its own number, or by ROMANESCO_TEST_SEED others. The same in every run.
std::uint64_t seed(std::uint64_t own);

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
