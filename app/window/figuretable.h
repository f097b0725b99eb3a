// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <cstddef>
#include <vector>

#include <QCoreApplication>
#include <QStringList>

#include "core/measure/measurement.h"

namespace romanesco {

/// What a trial came to, in figures: a row for each way that was tried.
struct FigureTable {
    Q_DECLARE_TR_FUNCTIONS(FigureTable)
public:
    struct Head {
        QString words;
        /// What it means.
        QString tip;
    };
    struct Figure {
        QString words;
        /// What it is sorted by.
        double value = 0.0;
    };
    struct Row {
        /// Of the trial.
        std::size_t number = 0;
        QString name;
        /// Beside the heads; none where there is a reason in their place, a sentence without its end.
        std::vector<Figure> figures = {};
        QString reason = {};
        /// Why it cannot be used although it was tried, likewise; else empty.
        QString obstacle = {};
    };

    Head nameHead;
    std::vector<Head> heads;
    std::vector<Row> rows = {};

    [[nodiscard]] static FigureTable of(const ColliderTrial &trial, QuerySet set);
    [[nodiscard]] static FigureTable of(const StepTrial &trial);
    [[nodiscard]] static FigureTable of(const FrameTrial &trial, FramePlace place);
    [[nodiscard]] static FigureTable of(const DepthTrial &trial);
    [[nodiscard]] static FigureTable of(const DigitTrial &trial);

    /// All of a row, a figure a line.
    [[nodiscard]] QString wordsOf(const Row &row) const;
};

}
