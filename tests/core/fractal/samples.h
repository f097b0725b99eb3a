// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstdint>
#include <string>

#include <QFile>
#include <QString>

#include "core/formats/fdoreader.h"
#include "core/formats/objreader.h"
#include "core/fractal/fractalgraph.h"
#include "tests/core/naive.h"
#include "tests/sourcetree.h"

/// The examples that come with the program, at any depth.
namespace romanesco::test {

struct Sample {
    FractalDescription description;
    Mesh mesh;
    FractalGraph graph;
};

const QString examples = QStringLiteral("resources/examples/");
/// Those of the benchmarks.
const QString workloads = QStringLiteral("tests/data/collide/");

inline std::string exampleText(const QString &file, const QString &folder = examples)
{
    QFile source(test::sourcePath("") + folder + file);
    return source.open(QIODevice::ReadOnly) ? source.readAll().toStdString() : std::string();
}

inline Sample sample(const QString &name, std::uint64_t depth, const QString &folder = examples)
{
    std::string text = exampleText(name + QStringLiteral(".fdo"), folder);
    const SourceRange digits = readFdo(text).description.value().depth.value().range;
    text.replace(digits.begin, digits.length(), std::to_string(depth));
    FractalDescription description = readFdo(text).description.value();
    Mesh mesh = readObj(exampleText(QString::fromStdString(description.meshPath), folder)).mesh;
    FractalGraph graph = FractalGraph::build(description, boundingSphere(mesh)).value();
    return {std::move(description), std::move(mesh), std::move(graph)};
}

}
