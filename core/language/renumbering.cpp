// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "renumbering.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <unordered_map>

namespace romanesco {

namespace {

/// How many entries of two lists are alike from one end on, of `most` at most.
template<typename IsAlike>
std::size_t alikeEntries(std::size_t most, IsAlike isAlike)
{
    std::size_t count = 0;
    while (count < most && isAlike(count)) {
        ++count;
    }
    return count;
}

class Renumberer
{
public:
    Renumberer(const FdoDocument &before, const FdoDocument &after)
        : m_before(before)
        , m_after(after)
    {
        const LineMap &old = before.syntax.map();
        const LineMap &now = after.syntax.map();
        const std::size_t most = std::min(before.syntax.lineCount(), after.syntax.lineCount());
        const std::size_t start = alikeEntries(most, [&](std::size_t i) { return old.lineText(i) == now.lineText(i); });
        const std::size_t end = alikeEntries(most - start, [&](std::size_t i) {
            return old.lineText(before.syntax.lineCount() - 1 - i) == now.lineText(after.syntax.lineCount() - 1 - i);
        });
        m_firstLine = after.syntax.lineCount() - end;

        // by their lines again, but of vectors only: what was inserted may stand between other new lines
        const std::vector<VectorEntry> &gone = before.model.vectors;
        const std::vector<VectorEntry> &fresh = after.model.vectors;
        const auto isAlike = [&](const VectorEntry &a, const VectorEntry &b) {
            return old.lineText(a.line) == now.lineText(b.line);
        };
        const std::size_t fewest = std::min(gone.size(), fresh.size());
        m_keptBefore = alikeEntries(fewest, [&](std::size_t i) { return isAlike(gone[i], fresh[i]); });
        const std::size_t keptAfter = alikeEntries(fewest - m_keptBefore, [&](std::size_t i) {
            return isAlike(gone[gone.size() - 1 - i], fresh[fresh.size() - 1 - i]);
        });
        m_goneEnd = gone.size() - keptAfter;
        m_newEnd = fresh.size() - keptAfter;
    }

    Renumbering run()
    {
        if (m_goneEnd == m_newEnd) {
            return {}; // as many as before: changed at most in their values
        }
        for (std::size_t line = m_firstLine; line < m_after.syntax.lineCount(); ++line) {
            std::visit([&](const auto &node) { renumber(line, node); }, m_after.syntax.line(line).declaration);
        }
        return std::move(m_result);
    }

private:
    void renumber(std::size_t, std::monostate) { }
    void renumber(std::size_t, const VectorDeclaration &) { }
    void renumber(std::size_t, const UnknownDeclaration &) { }

    void renumber(std::size_t line, const TransformationDeclaration &node)
    {
        for (const std::optional<VectorReference> &reference : node.results) {
            if (reference) {
                renumber(line, *reference);
            }
        }
    }

    void renumber(std::size_t line, const ObjectDeclaration &node)
    {
        for (const SetExpression &set : node.value.sets) {
            for (const TransformationUse &use : set.uses) {
                for (const VectorReference &argument : use.arguments) {
                    renumber(line, argument);
                }
            }
        }
    }

    void renumber(std::size_t line, const VectorReference &reference)
    {
        const bool meantSomething =
            reference.number && *reference.number > m_keptBefore && *reference.number <= m_before.model.vectors.size();
        if (!meantSomething) {
            return;
        }
        const SourceRange range = m_after.syntax.range(line, reference.word.range);
        const std::size_t index = *reference.number - 1;
        if (index >= m_goneEnd) {
            m_result.edits.push_back({range, std::to_string(index - m_goneEnd + m_newEnd + 1)});
        } else if (const auto equal = equalOf(index)) {
            m_result.edits.push_back({range, std::to_string(*equal + 1)});
        } else {
            m_result.orphans.push_back(range);
        }
    }

    /// Of equal vectors nobody can tell which one went: one that is left, and written alike, will do.
    std::optional<std::size_t> equalOf(std::size_t gone)
    {
        if (m_left.empty()) {
            for (std::size_t i = m_newEnd; i-- > 0;) {
                m_left[m_after.syntax.map().lineText(m_after.model.vectors[i].line)] = i;
            }
        }
        const auto found = m_left.find(m_before.syntax.map().lineText(m_before.model.vectors[gone].line));
        return found == m_left.end() ? std::nullopt : std::optional(found->second);
    }

    const FdoDocument &m_before;
    const FdoDocument &m_after;
    /// Where the lines begin that both texts end with.
    std::size_t m_firstLine = 0;
    /// Vectors [0, m_keptBefore) are the same in both; [m_keptBefore, m_goneEnd) of the text before gave way to
    /// [m_keptBefore, m_newEnd).
    std::size_t m_keptBefore = 0;
    std::size_t m_goneEnd = 0;
    std::size_t m_newEnd = 0;
    /// Lines of the vectors that are left, once one is asked for.
    std::unordered_map<std::string_view, std::size_t> m_left;
    Renumbering m_result;
};

}

Renumbering renumbering(const FdoDocument &before, const FdoDocument &after)
{
    return Renumberer(before, after).run();
}

}
