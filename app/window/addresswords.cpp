// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "addresswords.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "core/formats/fdoreader.h"
#include "core/language/origin.h"

namespace romanesco {

namespace {

/// Before and after what is left out.
constexpr qsizetype shownSteps = 4;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(AddressWords)
};

/// None where the text is not the scene's, or not sound.
QStringList wordsOf(const FractalGraph &graph, const std::vector<Step> &steps, const std::string &text)
{
    const FdoResult read = readFdo(text);
    StateTable table(graph);
    const std::optional<Address> address = addressOf(table, steps);
    if (!read.description || !address) {
        return {};
    }
    QStringList words;
    for (const OriginStep &step : origin(FdoDocument(text), *read.description, *address)) {
        words << QString::fromStdString(step.words);
    }
    return words;
}

}

QString addressWords(const Scene &scene, const Selection &selection, const std::string &text)
{
    const SceneItem &item = scene.items[selection.item];
    if (selection.steps.empty() || !item.path.empty()) {
        const QString name = QString::fromStdString(item.path.empty() ? item.model->meshPath : item.path);
        const auto steps = static_cast<qulonglong>(selection.steps.size());
        return steps == 0 ? name : Words::tr("%1, steps in: %2").arg(name, QLocale().toString(steps));
    }
    QStringList words = wordsOf(item.model->graph, selection.steps, text);
    if (words.size() > 2 * shownSteps + 1) {
        const QString count = Words::tr("… %1 more …").arg(QLocale().toString(words.size() - 2 * shownSteps));
        words = words.first(shownSteps) + QStringList{count} + words.last(shownSteps);
    }
    return words.join(QStringLiteral(" › "));
}

}
