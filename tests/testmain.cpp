// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "testmain.h"

#include <algorithm>
#include <cstdio>
#include <utility>
#include <vector>

#include <QCoreApplication>
#include <QTest>

namespace {

std::vector<std::function<std::unique_ptr<QObject>()>> &registry()
{
    static std::vector<std::function<std::unique_ptr<QObject>()>> makers;
    return makers;
}

QString shortName(const QObject &object)
{
    const QString name = QString::fromLatin1(object.metaObject()->className());
    return name.mid(name.lastIndexOf(QLatin1Char(':')) + 1);
}

}

std::uint64_t romanesco::test::seed(std::uint64_t own)
{
    static const auto others = static_cast<std::uint64_t>(qEnvironmentVariableIntValue("ROMANESCO_TEST_SEED"));
    return own + 1'000'003 * others;
}

void romanesco::test::registerTest(std::function<std::unique_ptr<QObject>()> make)
{
    registry().push_back(std::move(make));
}

/// test_NAME [CLASS] [Qt Test's options]: all classes, or the one.
int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    QStringList arguments = QCoreApplication::arguments();
    QString wanted;
    if (arguments.size() > 1 && !arguments[1].startsWith(QLatin1Char('-'))) {
        wanted = arguments.takeAt(1);
    }
    int failures = 0;
    bool isFound = false;
    for (const auto &make : registry()) {
        const std::unique_ptr<QObject> object = make();
        if (wanted.isEmpty() || shortName(*object).compare(wanted, Qt::CaseInsensitive) == 0) {
            isFound = true;
            failures += QTest::qExec(object.get(), arguments);
        }
    }
    if (!isFound) {
        std::fprintf(stderr, "no test class %s\n", qPrintable(wanted));
        return 1;
    }
    return std::min(failures, 127);
}
