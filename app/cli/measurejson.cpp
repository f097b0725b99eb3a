// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#include "measurejson.h"

#include <array>
#include <cmath>

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace romanesco::cli {

namespace {

QString text(std::string_view words)
{
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

QJsonValue number(std::size_t count)
{
    return static_cast<qint64>(count);
}

/// Puts a share and its interval; nulls where it is of nothing.
void put(QJsonObject &object, const QString &name, const Share &share, bool isThere)
{
    const QString interval = name + QStringLiteral("_ci");
    if (!isThere || share.of == 0) {
        object[name] = QJsonValue();
        object[interval] = QJsonValue();
        return;
    }
    const auto [least, greatest] = share.interval();
    object[name] = share.value();
    object[interval] = QJsonArray{least, greatest};
}

void put(QJsonObject &object, const QString &name, const QString &spread, const Spread &times, bool isThere)
{
    object[name] = isThere ? QJsonValue(times.median) : QJsonValue();
    object[spread] = isThere ? QJsonValue(QJsonArray{times.lowerQuartile, times.upperQuartile}) : QJsonValue();
}

QJsonObject json(const ColliderRow &row)
{
    const bool isThere = row.reason.empty();
    const Survey &survey = row.survey;
    const auto orNull = [&](const QJsonValue &value) { return isThere ? value : QJsonValue(); };
    QJsonObject object{
        {QStringLiteral("collider"), text(colliderNames[static_cast<std::size_t>(row.kind)])},
        {QStringLiteral("tolerance"), row.tolerance ? QJsonValue(*row.tolerance) : QJsonValue()},
        {QStringLiteral("queries"), text(nameOf(row.queries))},
        {QStringLiteral("asked"), orNull(number(survey.asked))},
        {QStringLiteral("face_tests_mean"), orNull(survey.faceTestsMean)},
        {QStringLiteral("face_tests_p99"), orNull(survey.faceTestsP99)},
        {QStringLiteral("node_visits_mean"), orNull(survey.nodeVisitsMean)},
        {QStringLiteral("bytes"), orNull(number(row.bytes))},
        {QStringLiteral("worst"), orNull(survey.worst)},
        {QStringLiteral("touching"), orNull(number(survey.missed.of))},
        {QStringLiteral("reason"), isThere ? QJsonValue() : QJsonValue(text(row.reason))},
    };
    constexpr std::array names{"wrong_1e-6", "wrong_1%", "wrong_10%"};
    static_assert(names.size() == Survey::wrongBy.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        put(object, text(names[i]), survey.wrong[i], isThere);
    }
    put(object, QStringLiteral("missed"), survey.missed, isThere);
    put(object, QStringLiteral("ns_median"), QStringLiteral("ns_quartiles"), row.nanoseconds, isThere);
    put(object, QStringLiteral("build_ms"), QStringLiteral("build_ms_quartiles"), row.buildMilliseconds, isThere);
    return object;
}

QJsonObject json(const ColliderTrial::Set &set)
{
    return {{QStringLiteral("queries"), text(nameOf(set.queries))},
            {QStringLiteral("points"), number(set.points)},
            {QStringLiteral("touching"), number(set.touching)},
            {QStringLiteral("undecided"), number(set.undecided)}};
}

QJsonObject json(const StepRow &row)
{
    QJsonObject object{
        {QStringLiteral("integrator"),
         row.isAsInDissertation ? QStringLiteral("dissertation") : QStringLiteral("romanesco")},
        {QStringLiteral("dt"), row.timeStep},
        {QStringLiteral("balls"), number(row.balls)},
        {QStringLiteral("face_tests_mean"), row.faceTests},
        {QStringLiteral("queries_mean"), row.queries},
        {QStringLiteral("energy_median"), row.energyMedian},
        {QStringLiteral("energy_worst"), row.energyWorst},
        {QStringLiteral("landing_median"), row.landingMedian},
        {QStringLiteral("landing_worst"), row.landingWorst},
    };
    put(object, QStringLiteral("us_median"), QStringLiteral("us_quartiles"), row.microseconds, true);
    put(object, QStringLiteral("missed"), row.missed, true);
    return object;
}

QJsonObject json(const FrameRow &row)
{
    const bool isThere = row.reason.empty();
    const auto orNull = [&](const QJsonValue &value) { return isThere ? value : QJsonValue(); };
    QJsonObject object{
        {QStringLiteral("place"), text(nameOf(row.place))},
        {QStringLiteral("tolerance"), row.tolerance},
        {QStringLiteral("copies"), orNull(number(row.cost.copies))},
        {QStringLiteral("faces"), orNull(number(row.cost.faces))},
        {QStringLiteral("states"), orNull(number(row.cost.statesVisited))},
        {QStringLiteral("bytes"), orNull(number(row.cost.bytes))},
        {QStringLiteral("rms"), orNull(row.moving.rms)},
        {QStringLiteral("off"), orNull(row.moving.share)},
        {QStringLiteral("rms_alone"), orNull(row.alone.rms)},
        {QStringLiteral("off_alone"), orNull(row.alone.share)},
        {QStringLiteral("reason"), isThere ? QJsonValue() : QJsonValue(text(row.reason))},
    };
    put(object, QStringLiteral("ms_median"), QStringLiteral("ms_quartiles"), row.milliseconds, isThere);
    return object;
}

QJsonObject json(const FrameReference &reference)
{
    return {{QStringLiteral("place"), text(nameOf(reference.place))},
            {QStringLiteral("tolerance"), reference.tolerance},
            {QStringLiteral("samples"), reference.samples},
            {QStringLiteral("rms_leftover"), reference.leftover.rms},
            {QStringLiteral("off_leftover"), reference.leftover.share}};
}

QJsonObject json(const DepthRow &row)
{
    const bool isThere = row.reason.empty();
    // JSON has no infinity: what is not seen is null
    const auto pixels = [&](double value) {
        return isThere && std::isfinite(value) ? QJsonValue(value) : QJsonValue();
    };
    return {{QStringLiteral("levels"), number(row.depth)},
            {QStringLiteral("size_log10"), isThere ? QJsonValue(row.sizeLog10) : QJsonValue()},
            {QStringLiteral("copies"), isThere ? number(row.copies) : QJsonValue()},
            {QStringLiteral("px_float"), pixels(row.inFloat)},
            {QStringLiteral("px_double"), pixels(row.inDouble)},
            {QStringLiteral("px_local_frames"), pixels(row.inFrames)},
            {QStringLiteral("reason"), isThere ? QJsonValue() : QJsonValue(text(row.reason))}};
}

/// As a string of digits, since JSON's numbers end at 2^53.
QJsonValue digitsOf(const std::optional<Count> &count)
{
    return count ? QJsonValue(text(count->toString())) : QJsonValue();
}

QJsonObject json(const DigitRow &row)
{
    QJsonObject object{{QStringLiteral("digits"), row.digits ? QJsonValue(*row.digits) : QJsonValue()},
                       {QStringLiteral("worst"), row.worst},
                       {QStringLiteral("rms"), row.rms},
                       {QStringLiteral("collapsed"), number(row.collapsed)},
                       {QStringLiteral("flat"), number(row.flat)},
                       {QStringLiteral("bytes"), digitsOf(row.bytes)}};
    put(object, QStringLiteral("ns_median"), QStringLiteral("ns_quartiles"), row.nanoseconds, true);
    return object;
}

template<typename Things>
QJsonArray jsonOfAll(const Things &things)
{
    QJsonArray array;
    for (const auto &thing : things) {
        array.append(json(thing));
    }
    return array;
}

QJsonObject json(const FrameTrial &trial)
{
    const bool isThere = trial.reason.empty();
    return {{QStringLiteral("reason"), isThere ? QJsonValue() : QJsonValue(text(trial.reason))},
            {QStringLiteral("device"), isThere ? QJsonValue(text(trial.device)) : QJsonValue()},
            {QStringLiteral("width"), FrameTrial::width},
            {QStringLiteral("height"), FrameTrial::height},
            {QStringLiteral("references"), jsonOfAll(trial.references)},
            {QStringLiteral("rows"), jsonOfAll(trial.rows)}};
}

QJsonObject json(const DepthTrial &trial)
{
    return {{QStringLiteral("reason"), trial.reason.empty() ? QJsonValue() : QJsonValue(text(trial.reason))},
            {QStringLiteral("rows"), jsonOfAll(trial.rows)}};
}

QJsonObject json(const DigitTrial &trial)
{
    return {{QStringLiteral("faces"), number(trial.faces)},
            {QStringLiteral("vertices"), number(trial.vertices)},
            {QStringLiteral("faces_in_all"), digitsOf(trial.facesInAll)},
            {QStringLiteral("is_whole"), trial.isWhole},
            {QStringLiteral("diagonal"), trial.diagonal},
            {QStringLiteral("rows"), jsonOfAll(trial.rows)}};
}

}

QByteArray jsonOf(const Measurement &measurement)
{
    const ColliderTrial &trial = measurement.colliders;
    QJsonObject object{
        {QStringLiteral("file"), text(measurement.source)}, {QStringLiteral("faces"), digitsOf(trial.faces)},
        {QStringLiteral("diagonal"), trial.diagonal},       {QStringLiteral("ball_radius"), trial.ballRadius},
        {QStringLiteral("sets"), jsonOfAll(trial.sets)},    {QStringLiteral("colliders"), jsonOfAll(trial.rows)},
    };
    if (measurement.steps) {
        object[QStringLiteral("timestep")] = jsonOfAll(measurement.steps->rows);
    }
    if (measurement.frames) {
        object[QStringLiteral("rendering")] = json(*measurement.frames);
    }
    if (measurement.depths) {
        object[QStringLiteral("depths")] = json(*measurement.depths);
    }
    if (measurement.digits) {
        object[QStringLiteral("export")] = json(*measurement.digits);
    }
    return QJsonDocument(object).toJson();
}

}
