// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#include "facetree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <format>
#include <limits>
#include <optional>

namespace romanesco {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double greatestCoordinate = 1e300;
constexpr std::size_t binCount = 16;

/// Below this, nodes are divided in halves, so that a tree cannot become deep: 2^31 faces take 29 of those.
constexpr std::size_t mostDepthByArea = FaceTree::mostDepth - 32;

struct Item {
    Box box;
    std::uint32_t face;
};

int widestAxis(const Box &box)
{
    const glm::dvec3 size = box.size();
    return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

/// Half of the surface of a box, scaled so that it cannot overflow.
double area(const Box &box, double scale)
{
    const glm::dvec3 size = box.size() * scale;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

/// The intervals of equal length that the middles of a node's items are sorted into, along an axis.
struct Bins {
    int axis = 0;
    double least = 0.0;
    double perUnit = 0.0;

    Bins(int along, const Box &middles)
        : axis(along)
        , least(middles.least[along])
        , perUnit(binCount / middles.size()[along])
    {
    }

    /// Whether there is more than one, in numbers that a double holds.
    [[nodiscard]] bool areUseful() const { return std::isfinite(perUnit); }
    [[nodiscard]] std::size_t operator()(const Item &item) const
    {
        return std::min(static_cast<std::size_t>((item.box.centre()[axis] - least) * perUnit), binCount - 1);
    }
};

/// Items in bins before it go to one side.
struct Split {
    Bins bins;
    std::size_t bin;
};

}

class FaceTree::Builder
{
public:
    Builder(const Mesh &mesh, FaceTree &tree)
        : m_mesh(mesh)
        , m_tree(tree)
    {
    }

    std::expected<void, std::string> build(const std::stop_token &stop)
    {
        if (m_mesh.faces.size() > std::uint32_t(1) << 31) {
            return std::unexpected(std::format("{} faces are too many (at most 2^31)", m_mesh.faces.size()));
        }
        if (auto taken = takeItems(); !taken || m_items.empty()) {
            return taken;
        }
        m_tree.m_nodes.reserve(m_items.size());
        m_tree.m_nodes.emplace_back();
        m_tasks.push_back({0, 0, 0, m_items.size()});
        while (!m_tasks.empty()) {
            if (stop.stop_requested()) {
                return std::unexpected("cancelled");
            }
            const Task task = m_tasks.back();
            m_tasks.pop_back();
            finish(task);
        }
        m_tree.m_nodes.shrink_to_fit();
        return {};
    }

private:
    /// A node that has its items, and nothing else.
    struct Task {
        std::uint32_t node;
        std::size_t depth;
        std::size_t begin;
        std::size_t end;
    };

    std::expected<void, std::string> takeItems()
    {
        m_items.reserve(m_mesh.faces.size());
        for (const Mesh::Face &face : m_mesh.faces) {
            Box box = Box::ofNothing();
            for (const std::uint32_t index : face) {
                const glm::dvec3 &vertex = m_mesh.vertices[index];
                for (int axis = 0; axis < 3; ++axis) {
                    if (!(std::abs(vertex[axis]) <= greatestCoordinate)) {
                        return std::unexpected(std::format("vertex {} is not finite, or too large (at most {})",
                                                           index + 1, greatestCoordinate));
                    }
                }
                box = box.with(vertex);
            }
            m_items.push_back({box, static_cast<std::uint32_t>(m_items.size())});
        }
        return {};
    }

    std::span<Item> items(const Task &task) { return std::span(m_items).subspan(task.begin, task.end - task.begin); }

    void finish(const Task &task)
    {
        assert(task.depth < mostDepth && "halves end before");
        Box box = Box::ofNothing();
        Box middles = Box::ofNothing();
        for (const Item &item : items(task)) {
            box = box.with(item.box);
            middles = middles.with(item.box.centre());
        }
        m_tree.m_nodes[task.node].box = box;
        if (task.end - task.begin <= mostFacesOfLeaf) {
            makeLeaf(task);
            return;
        }
        const std::size_t middle = task.begin + partition(task, middles);
        const auto child = static_cast<std::uint32_t>(m_tree.m_nodes.size());
        m_tree.m_nodes[task.node].first = child;
        m_tree.m_nodes.resize(child + 2);
        m_tasks.push_back({child + 1, task.depth + 1, middle, task.end});
        m_tasks.push_back({child, task.depth + 1, task.begin, middle});
    }

    void makeLeaf(const Task &task)
    {
        Node &node = m_tree.m_nodes[task.node];
        node.first = static_cast<std::uint32_t>(m_tree.m_faces.size());
        node.faceCount = static_cast<std::uint32_t>(task.end - task.begin);
        for (const Item &item : items(task)) {
            m_tree.m_faces.push_back(item.face);
        }
        std::sort(m_tree.m_faces.begin() + node.first, m_tree.m_faces.end());
    }

    /// How many items go to the first side: all of those come first.
    std::size_t partition(const Task &task, const Box &middles)
    {
        const std::span<Item> all = items(task);
        if (task.depth < mostDepthByArea) {
            if (const auto split = leastArea(all, middles)) {
                const auto isBefore = [&](const Item &item) { return split->bins(item) < split->bin; };
                return static_cast<std::size_t>(std::partition(all.begin(), all.end(), isBefore) - all.begin());
            }
        }
        const std::size_t half = all.size() / 2;
        const auto middle = all.begin() + static_cast<std::ptrdiff_t>(half);
        std::ranges::nth_element(all, middle, {},
                                 [axis = widestAxis(middles)](const Item &item) { return item.box.centre()[axis]; });
        return half;
    }

    std::optional<Split> leastArea(std::span<const Item> all, const Box &middles)
    {
        std::optional<Split> best;
        double least = infinity;
        const Box &root = m_tree.m_nodes.front().box;
        const double scale = 1.0 / root.size()[widestAxis(root)];
        for (int axis = 0; axis < 3; ++axis) {
            const Bins bins(axis, middles);
            if (bins.areUseful()) {
                sortInto(bins, all);
                const auto [cost, bin] = cheapest(scale);
                if (cost < least) {
                    least = cost;
                    best = Split{bins, bin};
                }
            }
        }
        return best;
    }

    struct Bin {
        Box box = Box::ofNothing();
        std::size_t count = 0;

        Bin &operator+=(const Bin &other)
        {
            box = box.with(other.box);
            count += other.count;
            return *this;
        }
        [[nodiscard]] double cost(double scale) const { return area(box, scale) * static_cast<double>(count); }
    };

    void sortInto(const Bins &bins, std::span<const Item> all)
    {
        m_bins.fill({});
        for (const Item &item : all) {
            m_bins[bins(item)] += {item.box, 1};
        }
    }

    /// The cost and the bin to divide before; both sides have items.
    std::pair<double, std::size_t> cheapest(double scale) const
    {
        std::array<double, binCount> after{};
        Bin side;
        for (std::size_t i = binCount; --i > 0;) {
            side += m_bins[i];
            after[i] = side.count > 0 ? side.cost(scale) : infinity;
        }
        std::pair<double, std::size_t> best{infinity, 0};
        side = {};
        for (std::size_t i = 1; i < binCount; ++i) {
            side += m_bins[i - 1];
            if (side.count > 0) {
                best = std::min(best, {side.cost(scale) + after[i], i});
            }
        }
        return best;
    }

    const Mesh &m_mesh;
    FaceTree &m_tree;
    std::vector<Item> m_items;
    std::vector<Task> m_tasks;
    std::array<Bin, binCount> m_bins;
};

std::expected<FaceTree, std::string> FaceTree::build(const Mesh &mesh, const std::stop_token &stop)
{
    FaceTree tree;
    if (auto built = Builder(mesh, tree).build(stop); !built) {
        return std::unexpected(std::move(built.error()));
    }
    return tree;
}

std::size_t FaceTree::memoryUse() const
{
    return sizeof(*this) + m_nodes.capacity() * sizeof(Node) + m_faces.capacity() * sizeof(std::uint32_t);
}

}
