// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <vector>

#include <boost/multiprecision/cpp_int.hpp>

#include "core/formats/fractaldescription.h"

/// The oracle of the fractal tests: fractals as explicit lists of levels, and all that is asked of them by trying
/// everything. Shares no code with the core but the types that tests are written in.
namespace romanesco::naive {

using boost::multiprecision::cpp_int;

/// A level: numbers of maps (equal where the maps are equal), and whether it may be passed over.
struct Level {
    std::vector<int> maps;
    bool mayPass = false;
    bool operator==(const Level &) const = default;
};
using Levels = std::vector<Level>;

/// Picks, outermost first.
using Picks = std::vector<int>;

/// All words of the levels, `#` left out of each, without repetition.
inline std::set<Picks> allPicks(const Levels &levels, std::size_t from = 0)
{
    std::set<Picks> suffixes{Picks{}};
    for (std::size_t i = levels.size(); i-- > from;) {
        std::set<Picks> longer;
        for (const Picks &suffix : suffixes) {
            if (levels[i].mayPass) {
                longer.insert(suffix);
            }
            for (const int map : levels[i].maps) {
                Picks picks{map};
                picks.insert(picks.end(), suffix.begin(), suffix.end());
                longer.insert(std::move(picks));
            }
        }
        suffixes = std::move(longer);
    }
    return suffixes;
}

inline cpp_int wordsAsWritten(const Levels &levels)
{
    cpp_int product = 1;
    for (const Level &level : levels) {
        product *= level.maps.size() + (level.mayPass ? 1 : 0);
    }
    return product;
}

/// How many sequences of picks there are, for as many levels as memory allows: the levels as a nondeterministic
/// automaton, made deterministic by sets of places, and its accepted words counted.
class PickCounter
{
public:
    explicit PickCounter(const Levels &levels)
        : m_levels(levels)
    {
    }

    cpp_int count() { return countFrom({0}); }

private:
    using Places = std::vector<std::size_t>;

    /// With all places that are reached by passing levels over.
    [[nodiscard]] Places closure(const Places &places) const
    {
        Places all;
        for (const std::size_t place : places) {
            std::size_t at = place;
            while (all.empty() || at > all.back()) {
                all.push_back(at);
                if (at == m_levels.size() || !m_levels[at].mayPass) {
                    break;
                }
                ++at;
            }
        }
        return all;
    }

    cpp_int countFrom(const Places &places)
    {
        const Places all = closure(places);
        const auto known = m_counts.find(all);
        if (known != m_counts.end()) {
            return known->second;
        }
        std::map<int, Places> next;
        for (const std::size_t place : all) {
            if (place < m_levels.size()) {
                for (const int map : m_levels[place].maps) {
                    next[map].push_back(place + 1);
                }
            }
        }
        cpp_int sum = all.back() == m_levels.size() ? 1 : 0;
        for (const auto &[map, after] : next) {
            sum += countFrom(after);
        }
        m_counts.emplace(all, sum);
        return sum;
    }

    const Levels &m_levels;
    std::map<Places, cpp_int> m_counts;
};

/// x ↦ a·x + b in long doubles, with its own arithmetic.
struct Affine {
    std::array<std::array<long double, 3>, 3> a{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::array<long double, 3> b{};
    auto operator<=>(const Affine &) const = default;
};
using Point = std::array<long double, 3>;

inline Affine fromCore(const AffineMap &map)
{
    Affine result;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            result.a[row][column] = map.linear[static_cast<int>(column)][static_cast<int>(row)];
        }
        result.b[row] = map.translation[static_cast<int>(row)];
    }
    return result;
}

inline Point applied(const Affine &map, const Point &p)
{
    Point result = map.b;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 3; ++column) {
            result[row] += map.a[row][column] * p[column];
        }
    }
    return result;
}

inline Affine product(const Affine &outer, const Affine &inner)
{
    Affine result;
    for (std::size_t column = 0; column < 3; ++column) {
        const Point image = applied(outer, {inner.a[0][column], inner.a[1][column], inner.a[2][column]});
        for (std::size_t row = 0; row < 3; ++row) {
            result.a[row][column] = image[row] - outer.b[row];
        }
    }
    result.b = applied(outer, inner.b);
    return result;
}

/// A fractal as a text would nest it, and written out.
struct Fractal {
    /// A level (count 0, with its set), or what is repeated.
    struct Item {
        std::uint64_t count = 0;
        SetId set = 0;
        std::vector<Item> body;
    };
    std::vector<AffineMap> maps;
    std::vector<Level> sets;
    std::vector<Item> items;

    [[nodiscard]] std::vector<SetId> setsOfLevels() const
    {
        std::vector<SetId> all;
        append(items, all);
        return all;
    }

    [[nodiscard]] Levels levels() const
    {
        Levels all;
        for (const SetId set : setsOfLevels()) {
            all.push_back(sets[set]);
        }
        return all;
    }

    [[nodiscard]] FractalDescription description() const
    {
        FractalDescription result;
        for (const Level &level : sets) {
            TransformSet &set = result.sets.emplace_back();
            set.holdsIdentity = level.mayPass;
            for (const int map : level.maps) {
                set.maps.push_back(maps[static_cast<std::size_t>(map)]);
                set.uses.push_back({static_cast<std::size_t>(map), static_cast<std::size_t>(map) + 1});
            }
        }
        LevelSequence::Builder builder;
        write(items, builder);
        result.levels = std::move(builder).build();
        return result;
    }

private:
    static void append(const std::vector<Item> &items, std::vector<SetId> &all)
    {
        for (const Item &item : items) {
            if (item.count == 0) {
                all.push_back(item.set);
            }
            for (std::uint64_t i = 0; i < item.count; ++i) {
                append(item.body, all);
            }
        }
    }

    static void write(const std::vector<Item> &items, LevelSequence::Builder &builder)
    {
        for (const Item &item : items) {
            if (item.count == 0) {
                builder.addLevel(item.set);
            } else {
                builder.beginRepeat(item.count);
                write(item.body, builder);
                builder.endRepeat();
            }
        }
    }
};

/// Random nesting of levels and repeats over the sets there are.
inline std::vector<Fractal::Item> randomItems(std::mt19937_64 &random, std::size_t setCount, int depth,
                                              std::uint64_t mostRepeats)
{
    std::vector<Fractal::Item> items;
    const std::uint64_t count = random() % 3 + (depth == 0 ? 1 : 0);
    for (std::uint64_t i = 0; i < count; ++i) {
        const bool isRepeat = depth < 3 && random() % 2 == 0;
        if (isRepeat) {
            items.push_back({random() % mostRepeats + 1, 0, randomItems(random, setCount, depth + 1, mostRepeats)});
        } else {
            items.push_back({0, static_cast<SetId>(random() % setCount), {}});
        }
    }
    return items;
}

/// Sets that hold some of the maps in any order, some with `#`; often equal to one another, or sharing maps.
inline std::vector<Level> randomSets(std::mt19937_64 &random, int mapCount)
{
    std::vector<Level> sets;
    const std::uint64_t count = random() % 4 + 1;
    for (std::uint64_t i = 0; i < count; ++i) {
        Level level;
        for (int map = 0; map < mapCount; ++map) {
            if (random() % 2 == 0) {
                level.maps.push_back(map);
            }
        }
        std::ranges::shuffle(level.maps, random);
        level.mayPass = level.maps.empty() || random() % 2 == 0;
        sets.push_back(std::move(level));
    }
    if (random() % 3 == 0) { // once more, in another order
        Level again = sets[random() % sets.size()];
        std::ranges::reverse(again.maps);
        sets.push_back(std::move(again));
    }
    return sets;
}

}
