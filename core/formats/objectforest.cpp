// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "objectforest.h"

#include <cassert>
#include <limits>

namespace romanesco {

namespace {

Position saturatedSum(Position a, Position b)
{
    Position sum = 0;
    return __builtin_add_overflow(a, b, &sum) ? std::numeric_limits<Position>::max() : sum;
}

Position saturatedProduct(Position a, Position b)
{
    Position product = 0;
    return __builtin_mul_overflow(a, b, &product) ? std::numeric_limits<Position>::max() : product;
}

}

std::string shortened(std::string_view words)
{
    constexpr std::size_t longest = 60;
    if (words.size() <= longest) {
        return std::string(words);
    }
    std::size_t end = longest;
    while (end > 0 && (static_cast<unsigned char>(words[end]) & 0xC0) == 0x80) {
        --end; // not within a character
    }
    return std::string(words.substr(0, end)) + "…";
}

std::uint32_t ObjectForest::add(ObjectNode node)
{
    const auto index = static_cast<std::uint32_t>(m_nodes.size());
    node.levels = node.endSet - node.firstSet;
    if (node.repeated != ObjectNode::none) {
        node.levels = saturatedSum(node.levels, saturatedProduct(m_nodes[node.repeated].iterationLevels, node.count));
    }
    if (node.next != ObjectNode::none) {
        const ObjectNode &next = m_nodes[node.next];
        node.levels = saturatedSum(node.levels, next.levels);
        node.height = next.height + 1;

        // Two equal jumps in a row are joined to one; else a jump of one begins.
        const bool hasJump = next.jump != ObjectNode::none && m_nodes[next.jump].jump != ObjectNode::none;
        const bool isEven = hasJump
            && next.height - m_nodes[next.jump].height
                == m_nodes[next.jump].height - m_nodes[m_nodes[next.jump].jump].height;
        node.jump = isEven ? m_nodes[next.jump].jump : node.next;
    }
    if (node.isRecursive && node.base != ObjectNode::none) {
        node.iterationLevels = node.levels - m_nodes[node.base].levels;
    }
    m_nodes.push_back(node);
    return index;
}

bool ObjectForest::standsOn(std::uint32_t node, std::uint32_t other) const
{
    return below(node, m_nodes[other].height) == other;
}

std::string ObjectForest::chain(std::uint32_t node, const NameTable &names) const
{
    constexpr std::uint32_t shownAtTop = 4;
    std::string text;
    std::uint32_t shown = 0;
    while (node != ObjectNode::none) {
        const ObjectNode &at = m_nodes[node];
        text += text.empty() ? "" : " → ";
        if (shown == shownAtTop && at.height > 2) {
            text += "…";
            node = below(node, 1);
            shown = 0;
            continue;
        }
        text += shortened(names[at.name]);
        ++shown;
        node = at.next;
    }
    return text;
}

void ObjectForest::writeLevels(std::uint32_t node, LevelSequence::Builder &builder) const
{
    // A frame stands on the node that ends it: the mesh for the outermost, a recursive's base inside a repeat.
    struct Frame {
        std::uint32_t node;
        std::uint32_t end;
    };
    std::vector<Frame> frames{{node, ObjectNode::none}};
    while (!frames.empty()) {
        Frame &frame = frames.back();
        if (frame.node == frame.end) {
            frames.pop_back();
            if (!frames.empty()) {
                builder.endRepeat();
            }
            continue;
        }
        const ObjectNode &at = m_nodes[frame.node];
        assert(!at.isBad && "only good objects have levels");
        for (SetId set = at.firstSet; set < at.endSet; ++set) {
            builder.addLevel(set);
        }
        frame.node = at.next;
        if (at.repeated != ObjectNode::none && at.count > 0 && m_nodes[at.repeated].iterationLevels > 0) {
            builder.beginRepeat(at.count);
            frames.push_back({at.repeated, m_nodes[at.repeated].base});
        }
    }
}

ObjectForest::Origin ObjectForest::origin(std::uint32_t node, Position position) const
{
    Origin found;
    // levels from the place looked for to the mesh; a recursive's iteration ends at its base
    Position left = m_nodes[node].levels - position;
    while (true) {
        // the lowest node that still has so many
        while (true) {
            const ObjectNode &at = m_nodes[node];
            if (at.next == ObjectNode::none || m_nodes[at.next].levels < left) {
                break;
            }
            node = m_nodes[at.jump].levels >= left ? at.jump : at.next;
        }
        const ObjectNode &at = m_nodes[node];
        const Position passed = at.levels - left;
        if (passed < at.endSet - at.firstSet) {
            found.node = node;
            found.set = at.firstSet + static_cast<SetId>(passed);
            return found;
        }
        const ObjectNode &recursive = m_nodes[at.repeated];
        const Position inRepeat = passed - (at.endSet - at.firstSet);
        found.passes.push_back({at.repeated, inRepeat / recursive.iterationLevels});
        left = m_nodes[recursive.base].levels + recursive.iterationLevels - inRepeat % recursive.iterationLevels;
        node = at.repeated;
    }
}

std::uint32_t ObjectForest::meshNode(std::uint32_t node) const
{
    return below(node, 0);
}

std::uint32_t ObjectForest::below(std::uint32_t node, std::uint32_t height) const
{
    while (m_nodes[node].height > height) {
        const std::uint32_t jump = m_nodes[node].jump;
        node = m_nodes[jump].height >= height ? jump : m_nodes[node].next;
    }
    return node;
}

}
