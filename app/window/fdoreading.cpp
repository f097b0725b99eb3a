// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "fdoreading.h"

#include <algorithm>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include "core/language/origin.h"

namespace romanesco {

namespace {

/// Before and after what is left out.
constexpr std::size_t shownSteps = 4;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(AddressWords)
};

/// Offsets of one text in another that differs from it in one stretch, such as a number.
class Alignment
{
public:
    Alignment(const std::string &from, const std::string &to)
        : m_shift(static_cast<std::ptrdiff_t>(to.size()) - static_cast<std::ptrdiff_t>(from.size()))
        , m_end(static_cast<std::size_t>(std::ranges::mismatch(from, to).in1 - from.begin()))
    {
    }
    [[nodiscard]] std::size_t operator()(std::size_t offset) const
    {
        return offset <= m_end ? offset : static_cast<std::size_t>(static_cast<std::ptrdiff_t>(offset) + m_shift);
    }

private:
    std::ptrdiff_t m_shift;
    /// Of what both begin with.
    std::size_t m_end;
};

bool isOfText(const SceneItem &item, const FdoReading *reading)
{
    return reading && item.path.empty();
}

/// Of what no text says more of.
std::vector<AddressStep> countedSteps(const SceneItem &item, std::size_t count)
{
    std::vector<AddressStep> steps{{QString::fromStdString(item.path.empty() ? item.model->meshPath : item.path)}};
    if (count > 0) {
        steps.push_back({Words::tr("steps in: %1").arg(QLocale().toString(static_cast<qulonglong>(count)))});
    }
    return steps;
}

}

std::shared_ptr<const FdoReading> FdoReading::of(const std::string &text)
{
    auto reading = std::make_shared<FdoReading>();
    reading->document.setText(text);
    FdoResult read = describeFdo(reading->document.syntax, reading->document.model);
    if (!read.description) {
        return nullptr;
    }
    reading->description = std::move(*read.description);
    return reading;
}

std::vector<AddressStep> addressSteps(const Scene &scene, const Selection &selection, const FdoReading *reading,
                                      const std::string &text)
{
    const SceneItem &item = scene.items[selection.item];
    StateTable table(item.model->graph);
    const auto address = isOfText(item, reading) ? addressOf(table, selection.steps) : std::nullopt;
    return address ? addressSteps(scene, selection.item, *address, reading, text)
                   : countedSteps(item, selection.steps.size());
}

std::vector<AddressStep> addressSteps(const Scene &scene, std::size_t item, const Address &address,
                                      const FdoReading *reading, const std::string &text)
{
    if (address.empty() || !isOfText(scene.items[item], reading)) {
        return countedSteps(scene.items[item], address.size());
    }
    std::vector<AddressStep> steps;
    const Alignment aligned(reading->document.syntax.text(), text);
    for (const OriginStep &step : origin(reading->document, reading->description, address)) {
        steps.push_back({QString::fromStdString(step.words),
                         SourceRange{aligned(step.use.begin), aligned(step.use.end)}, step.pass});
    }
    return steps;
}

QString addressWords(const std::vector<AddressStep> &steps)
{
    QStringList words;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        if (steps.size() <= 2 * shownSteps + 1 || i < shownSteps || i >= steps.size() - shownSteps) {
            words << steps[i].words;
        } else if (i == shownSteps) {
            words << Words::tr("… %1 more …").arg(QLocale().toString(qulonglong(steps.size() - 2 * shownSteps)));
        }
    }
    return words.join(QStringLiteral(" › "));
}

std::optional<Step> mapAt(const FdoReading &reading, const std::string &text, std::size_t offset)
{
    const Alignment aligned(text, reading.document.syntax.text());
    const std::optional<UseOfSet> use = useAt(reading.document, reading.description, aligned(offset));
    return use && use->map ? std::optional(Step{use->set, *use->map}) : std::nullopt;
}

}
