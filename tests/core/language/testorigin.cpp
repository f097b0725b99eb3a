// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include <algorithm>
#include <format>
#include <optional>

#include <QTest>
#include <rapidcheck.h>

#include "core/formats/fdoreader.h"
#include "core/language/origin.h"
#include "tests/testmain.h"

namespace romanesco::test {

namespace {

/// A random text of objects and recursives, every set with one use of its own, and what its levels are by writing them
/// all out. Nothing of the product is used.
class Plan
{
public:
    Plan()
    {
        m_objects.push_back({"x"});
        m_text = "x. \"x.obj\"\n";
        const int count = *rc::gen::inRange(1, 8);
        for (int i = 0; i < count; ++i) {
            addObject(std::format("o{}", i));
        }
        m_objects.push_back(wrapped("<$>"));
        write(m_objects.back());
    }

    /// The text with the vectors that its uses count.
    [[nodiscard]] std::string text() const
    {
        std::string vectors = "scale 0.5 0.5 0.5\n";
        for (int i = 0; i < m_uses; ++i) {
            vectors += std::format("v {} 0 0\n", i + 1);
        }
        return vectors + "t.p. (p, #, scale)\n" + m_text;
    }

    /// The steps of the result, a word for each level: "o3[2] t.7".
    [[nodiscard]] std::vector<std::string> levels() const
    {
        std::vector<std::string> words;
        write(m_objects.size() - 1, 0, words, m_objects.back().name);
        return words;
    }

private:
    struct Object {
        std::string name;
        std::vector<int> uses = {};
        std::size_t inner = 0;
        std::optional<std::size_t> base = std::nullopt;
        int depth = 0; // of inner, where that is a recursive
    };

    [[nodiscard]] Object wrapped(const std::string &name)
    {
        Object object{name};
        const int sets = *rc::gen::inRange(0, 3);
        for (int i = 0; i < sets; ++i) {
            object.uses.push_back(++m_uses);
        }
        object.inner = *rc::gen::inRange<std::size_t>(0, m_objects.size());
        object.depth = m_objects[object.inner].base ? *rc::gen::inRange(0, 4) : 0;
        return object;
    }

    void addObject(const std::string &name)
    {
        Object object = wrapped(name);
        const std::vector<std::size_t> bases = basesOf(object);
        if (*rc::gen::arbitrary<bool>() && !bases.empty()) {
            object.base = bases[*rc::gen::inRange<std::size_t>(0, bases.size())];
        }
        m_objects.push_back(object);
        write(object);
    }

    /// What the name after an object's sets stands on: the object itself, or the base of a recursive.
    [[nodiscard]] std::size_t under(const Object &object) const
    {
        return m_objects[object.inner].base.value_or(object.inner);
    }

    [[nodiscard]] std::vector<std::size_t> basesOf(const Object &object) const
    {
        std::vector<std::size_t> bases;
        for (std::size_t at = under(object);; at = under(m_objects[at])) {
            bases.push_back(at);
            if (at == 0) {
                return bases;
            }
        }
    }

    void write(const Object &object)
    {
        m_text += object.name + (object.base ? '<' + m_objects[*object.base].name + '>' : "") + ". ";
        for (const int use : object.uses) {
            m_text += std::format("[t.{}] ", use + 1); // the scale is vector 1
        }
        m_text += m_objects[object.inner].name;
        m_text += m_objects[object.inner].base ? std::format(" {}\n", object.depth) : "\n";
    }

    /// The levels from an object down to an end; label is what its own sets are said to be in.
    void write(std::size_t index, std::size_t end, std::vector<std::string> &words, const std::string &label) const
    {
        const Object &object = m_objects[index];
        for (const int use : object.uses) {
            words.push_back(std::format("{} t.{}", label, use + 1));
        }
        if (index == 0) {
            return;
        }
        const Object &inner = m_objects[object.inner];
        for (int pass = 0; inner.base && pass < object.depth; ++pass) {
            write(object.inner, *inner.base, words, std::format("{}[{}]", inner.name, pass + 1));
        }
        const std::size_t next = under(object);
        if (next != end) {
            write(next, end, words, m_objects[next].name);
        }
    }

    std::vector<Object> m_objects;
    std::string m_text;
    int m_uses = 0;
};

const std::string nested = "v 1 0 0\nhalf .5 .5 .5\nt.p. (p, #, half)\nx. \"x.obj\"\ny. [#, t.1] x\n"
                           "z<x>. [t.1, t.1, t.2, #] y\n<$>. [t.2] z 9223372036854775000\n";

}

class TestOrigin : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyLevelIsWhereItIsWritten();
    void aPassIsTheDepthThatEndsThere();
    void depthCostsNothing();
    void anAddressReadsAsTheText();
    void usesStandForTheirMaps();
    void whatIsBeyondEndsTheList();
};

void TestOrigin::everyLevelIsWhereItIsWritten()
{
    const bool holds = rc::check([] {
        const Plan plan;
        const std::string text = plan.text();
        const FdoDocument document(text);
        const FdoResult result = describeFdo(document.syntax, document.model);
        if (!result.description) {
            RC_FAIL(result.diagnostics.front().message() + '\n' + text);
        }
        const std::vector<std::string> levels = plan.levels();
        RC_ASSERT(result.description->levels.levelCount() == levels.size());
        Address address;
        for (Position position = 0; position < levels.size(); ++position) {
            address.push_back({position, 0});
        }
        const std::vector<OriginStep> steps = origin(document, *result.description, address);
        RC_ASSERT(steps.size() == levels.size());
        for (std::size_t i = 0; i < steps.size(); ++i) {
            RC_ASSERT(steps[i].words == levels[i]);
            const SetId set = result.description->levels.set(result.description->levels.locate(i).slot);
            for (const std::size_t offset : {steps[i].use.begin, steps[i].use.end}) {
                RC_ASSERT((useAt(document, *result.description, offset) == UseOfSet{set, 0}));
            }
        }
    });
    QVERIFY(holds);
}

/// Of what <$> repeats; what stands outside or inside has none.
void TestOrigin::aPassIsTheDepthThatEndsThere()
{
    const FdoDocument document("v 1 0 0\nx. \"x.obj\"\nt.p. (p, #, #)\nw<x>. [t.1] x\nb. w 2\nz<b>. [t.1] [t.1] b\n"
                               "y. z 3\n<$>. [t.1] y\n");
    const FdoResult result = describeFdo(document.syntax, document.model);
    QVERIFY(result.description);
    Address address;
    for (Position position = 0; position < result.description->levels.levelCount(); ++position) {
        address.push_back({position, 0});
    }
    std::vector<std::uint64_t> passes;
    for (const OriginStep &step : origin(document, *result.description, address)) {
        passes.push_back(step.pass.value_or(0));
    }
    QCOMPARE(passes, std::vector<std::uint64_t>({0, 1, 1, 2, 2, 3, 3, 0, 0}));
}

void TestOrigin::depthCostsNothing()
{
    const FdoDocument document(nested);
    const FractalDescription description = describeFdo(document.syntax, document.model).description.value();
    const std::vector<OriginStep> steps = origin(
        document, description, {{0, 0}, {1, 0}, {9'223'372'036'854'775'000u, 0}, {18'446'744'073'709'550'000u, 0}});
    QCOMPARE(steps.size(), std::size_t{4});
    QCOMPARE(steps[1].words, std::string("z[1] t.1"));
    QCOMPARE(steps[2].words, std::string("y t.1"));
    QCOMPARE(steps[3].words, std::string("y t.1"));
}

void TestOrigin::anAddressReadsAsTheText()
{
    const FdoDocument document(nested);
    const FractalDescription description = describeFdo(document.syntax, document.model).description.value();
    const std::vector<OriginStep> steps = origin(document, description, {{0, 0}, {5, 1}, {6, 0}});
    QCOMPARE(steps.size(), std::size_t{3});
    QCOMPARE(steps[0].words + " › " + steps[1].words + " › " + steps[2].words,
             std::string("<$> t.2 › z[3] t.2 › y t.1"));
    const auto words = [](SourceRange range) { return nested.substr(range.begin, range.length()); };
    QCOMPARE(words(steps[0].declaration), std::string("<$>"));
    QCOMPARE(words(steps[1].declaration), std::string("z"));
    QCOMPARE(words(steps[2].use), std::string("t.1"));
}

void TestOrigin::usesStandForTheirMaps()
{
    const FdoDocument document(nested);
    const FractalDescription description = describeFdo(document.syntax, document.model).description.value();
    const auto at = [&](const char *words, std::size_t further) {
        return useAt(document, description, nested.find(words) + further);
    };
    QVERIFY((at("[t.1, t.1, t.2, #]", 2) == UseOfSet{1, 0}));
    QVERIFY((at("[t.1, t.1, t.2, #]", 7) == UseOfSet{1, 0})); // repeats the first
    QVERIFY((at("[t.1, t.1, t.2, #]", 12) == UseOfSet{1, 1}));
    QVERIFY((at("[t.1, t.1, t.2, #]", 16) == UseOfSet{1, std::nullopt}));
    QVERIFY(!at("z<x>.", 0));
    QVERIFY(!at("v 1 0 0", 3));
    QVERIFY(!useAt(document, description, nested.size() + 10));
}

void TestOrigin::whatIsBeyondEndsTheList()
{
    const FdoDocument document("v 1 0 0\nt.p. (p, #, #)\nx. \"x.obj\"\n<$>. [t.1] [#] x\n");
    const FractalDescription description = describeFdo(document.syntax, document.model).description.value();
    QCOMPARE(origin(document, description, {{0, 0}, {2, 0}}).size(), std::size_t{1});
    QCOMPARE(origin(document, description, {{0, 1}}).size(), std::size_t{0});
    QCOMPARE(origin(document, description, {{1, 0}}).size(), std::size_t{0}); // nothing but #
    QCOMPARE(origin(document, description, {}).size(), std::size_t{0});
}

}

ROMANESCO_TEST(romanesco::test::TestOrigin)

#include "testorigin.moc"
