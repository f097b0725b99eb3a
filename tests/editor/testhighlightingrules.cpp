// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <map>
#include <set>
#include <vector>

#include <KSyntaxHighlighting/Repository>
#include <QTemporaryDir>
#include <QTest>
#include <QXmlStreamReader>
#include <QXmlStreamWriter>

#include "highlighted.h"
#include "tests/sourcetree.h"

using namespace romanesco::test;
using KSyntaxHighlighting::Definition;
using KSyntaxHighlighting::Repository;

namespace {

QString pathOf(const QString &language)
{
    return sourcePath("resources/syntax/") + language + QStringLiteral(".xml");
}

/// One thing done wrong to a definition.
struct Fault {
    int element = -1;  ///< which of the elements, as they open in the file
    QString attribute; ///< left out where empty: the element, with all in it
    QString value;     ///< left out where empty: the attribute
    QString words;     ///< for who has to add a sample
};

/// The name of the context that a switch such as "#pop!Rest" enters; empty where it enters none.
QString entered(QStringView contextSwitch)
{
    const QStringView name = contextSwitch.mid(contextSwitch.lastIndexOf(QLatin1Char('!')) + 1);
    return name.startsWith(QLatin1Char('#')) ? QString() : name.toString();
}

/// All faults with one rule missing, one rule that does not leave its context, one context that nothing falls through or
/// that goes on over the end of its line.
std::vector<Fault> faultsOf(const QByteArray &definition)
{
    std::vector<Fault> faults;
    std::set<QString> enteredContexts;
    std::map<QString, Fault> unendingContexts;
    QString context;
    QXmlStreamReader xml(definition);
    for (int element = -1; !xml.atEnd();) {
        if (xml.readNext() == QXmlStreamReader::EndElement && xml.name() == QLatin1String("context")) {
            context.clear();
        }
        if (!xml.isStartElement()) {
            continue;
        }
        ++element;
        const QXmlStreamAttributes attributes = xml.attributes();
        const QString next = attributes.value(QLatin1String("context")).toString();
        if (xml.name() == QLatin1String("context")) {
            context = attributes.value(QLatin1String("name")).toString();
            const QStringView fallthrough = attributes.value(QLatin1String("fallthroughContext"));
            if (!fallthrough.isEmpty()) {
                faults.push_back(
                    {element, QStringLiteral("fallthroughContext"), {}, context + QLatin1String(" falls")});
                enteredContexts.insert(entered(fallthrough));
            }
            if (attributes.value(QLatin1String("lineEndContext")) != QLatin1String("#stay")) {
                unendingContexts[context] = {element, QStringLiteral("lineEndContext"), QStringLiteral("#stay"),
                                             context + QLatin1String(" ends with its line")};
            }
        } else if (!context.isEmpty()) {
            const bool isInclusion = xml.name() == QLatin1String("IncludeRules");
            const auto what = isInclusion                        ? QLatin1String("context")
                : attributes.hasAttribute(QLatin1String("char")) ? QLatin1String("char")
                                                                 : QLatin1String("String");
            const QString words = QStringLiteral("%1: %2 %3").arg(context, xml.name(), attributes.value(what));
            faults.push_back({element, {}, {}, words});
            if (!isInclusion && next != QLatin1String("#stay")) {
                faults.push_back({element, QStringLiteral("context"), QStringLiteral("#stay"),
                                  words + QLatin1String(" leads to ") + next});
                enteredContexts.insert(entered(next));
            }
        }
    }
    // Contexts that are only included do not end, and parameters are entered only where their ( is in sight.
    for (const auto &[name, fault] : unendingContexts) {
        if (enteredContexts.contains(name) && name != QLatin1String("Parameters")) {
            faults.push_back(fault);
        }
    }
    return faults;
}

/// The definition with the fault, under another name.
QByteArray faulty(const QByteArray &definition, const Fault &fault, const QString &name)
{
    QByteArray out;
    QXmlStreamReader xml(definition);
    QXmlStreamWriter writer(&out);
    for (int element = -1; !xml.atEnd();) {
        xml.readNext();
        if (xml.isDTD()) {
            continue; // its entities are read as what they stand for
        }
        if (!xml.isStartElement()) {
            writer.writeCurrentToken(xml);
            continue;
        }
        ++element;
        if (element == fault.element && fault.attribute.isEmpty()) {
            xml.skipCurrentElement();
            continue;
        }
        writer.writeStartElement(xml.name().toString());
        for (const QXmlStreamAttribute &attribute : xml.attributes()) {
            QString value = attribute.value().toString();
            if (xml.name() == QLatin1String("language") && attribute.name() == QLatin1String("name")) {
                value = name;
            }
            if (element == fault.element && attribute.name() == fault.attribute) {
                value = fault.value;
            }
            if (!value.isEmpty()) {
                writer.writeAttribute(attribute.name().toString(), value);
            }
        }
    }
    return out;
}

/// A repository that has the definitions given, beside all others.
class OwnRepository
{
public:
    bool add(const QString &name, const QByteArray &definition)
    {
        QDir().mkpath(m_folder.filePath(QStringLiteral("syntax")));
        QFile file(m_folder.filePath(QStringLiteral("syntax/%1.xml").arg(name)));
        return file.open(QIODevice::WriteOnly) && file.write(definition) == definition.size();
    }
    void read() { m_repository.addCustomSearchPath(m_folder.path()); }
    [[nodiscard]] Definition find(const QString &name) const { return m_repository.definitionForName(name); }

private:
    QTemporaryDir m_folder;
    Repository m_repository;
};

}

/// A rule that could as well be missing has no sample, or no use. So each is taken out in turn, and some sample in
/// tests/golden/highlighting has to look different.
class TestHighlightingRules : public QObject
{
    Q_OBJECT
private Q_SLOTS:
    void everyAttributeOccurs_data();
    void everyAttributeOccurs();
    void everyFaultShowsInASample_data();
    void everyFaultShowsInASample();
};

void TestHighlightingRules::everyAttributeOccurs_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("fdo") << QStringLiteral("fdo");
    QTest::newRow("sdo") << QStringLiteral("sdo");
}

void TestHighlightingRules::everyAttributeOccurs()
{
    QFETCH(const QString, language);
    std::set<QString> missing;
    QXmlStreamReader xml(bytesOf(pathOf(language)));
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == QLatin1String("itemData")) {
            missing.insert(xml.attributes().value(QLatin1String("name")).toString());
        }
    }
    QVERIFY(!xml.hasError() && missing.size() > 5);
    const Repository repository;
    for (const QString &path : samples(language)) {
        LineHighlighter highlighter(repository.definitionForFileName(path));
        for (const QString &line : linesOf(path)) {
            for (const Run &run : highlighter.runs(line)) {
                missing.erase(run.attribute);
            }
        }
    }
    QCOMPARE(QStringList(missing.begin(), missing.end()).join(QLatin1Char(' ')), QString());
}

void TestHighlightingRules::everyFaultShowsInASample_data()
{
    everyAttributeOccurs_data();
}

void TestHighlightingRules::everyFaultShowsInASample()
{
    QFETCH(const QString, language);
    const QByteArray definition = bytesOf(pathOf(language));
    const std::vector<Fault> faults = faultsOf(definition);
    QVERIFY(faults.size() > 50);

    // All at once, since reading a repository takes long.
    OwnRepository repository;
    const auto name = [](std::size_t i) { return QStringLiteral("Faulty%1").arg(i); };
    const QString whole = QStringLiteral("Whole");
    QVERIFY(repository.add(whole, faulty(definition, {}, whole)));
    for (std::size_t i = 0; i < faults.size(); ++i) {
        QVERIFY(repository.add(name(i), faulty(definition, faults[i], name(i))));
    }
    repository.read();

    std::vector<QStringList> texts;
    std::vector<QString> colours;
    const Repository usual;
    for (const QString &path : samples(language)) {
        texts.push_back(linesOf(path));
        colours.push_back(highlighted(usual.definitionForFileName(path), texts.back()));
    }
    const auto isNoticed = [&](const Definition &other) {
        for (std::size_t i = 0; i < texts.size(); ++i) {
            if (highlighted(other, texts[i]) != colours[i]) {
                return true;
            }
        }
        return false;
    };
    QVERIFY(repository.find(whole).isValid() && !isNoticed(repository.find(whole)));
    QStringList unnoticed;
    for (std::size_t i = 0; i < faults.size(); ++i) {
        const Definition other = repository.find(name(i));
        QVERIFY2(other.isValid(), qPrintable(faults[i].words));
        if (!isNoticed(other)) {
            unnoticed += faults[i].words;
        }
    }
    QCOMPARE(unnoticed.join(QLatin1Char('\n')), QString());
}

QTEST_GUILESS_MAIN(TestHighlightingRules)

#include "testhighlightingrules.moc"
