// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/items/condition_tests.h"

#include <cassert>

namespace povpreview::items {

namespace {

/// A node of the condition's tree; leaves are solids.
struct Node {
    ConditionStep step;
    std::size_t left = 0, right = 0;
    std::uint32_t leaves = 1;
};

/// The tree of a postfix program, root last; empty if it is none.
std::vector<Node> tree_of(std::span<const ConditionStep> steps, std::size_t solids) {
    std::vector<Node> nodes;
    std::vector<std::size_t> stack;
    for (const ConditionStep step : steps) {
        Node node{step};
        if (step >= 0) {
            if (static_cast<std::size_t>(step) >= solids) return {};
        } else {
            const std::size_t operands = step == condition_not ? 1 : 2;
            if (step < condition_or || stack.size() < operands) return {};
            node.right = node.left = stack.back();
            stack.pop_back();
            node.leaves = nodes[node.left].leaves;
            if (operands == 2) {
                node.left = stack.back();
                stack.pop_back();
                node.leaves += nodes[node.left].leaves;
            }
        }
        stack.push_back(nodes.size());
        nodes.push_back(node);
    }
    return stack.size() == 1 ? nodes : std::vector<Node>();
}

/// A part of the tree whose tests start at number `first`.
struct Part {
    std::size_t node;
    std::uint32_t first, if_true, if_false;
    bool inverted;
};

}  // namespace

std::optional<std::vector<ConditionTest>> condition_tests(std::span<const ConditionStep> steps,
                                                          std::size_t solids) {
    assert(!steps.empty());
    const std::vector<Node> nodes = tree_of(steps, solids);
    if (nodes.empty()) return std::nullopt;
    std::vector<ConditionTest> tests(nodes.back().leaves);
    std::vector<Part> parts{
        {nodes.size() - 1, 0, ConditionTest::holds, ConditionTest::fails, false}};
    while (!parts.empty()) {
        const Part part = parts.back();
        parts.pop_back();
        const Node& node = nodes[part.node];
        if (node.step >= 0) {
            tests[part.first] = {static_cast<std::uint32_t>(node.step), part.inverted, part.if_true,
                                 part.if_false};
        } else if (node.step == condition_not) {
            parts.push_back({node.left, part.first, part.if_false, part.if_true, !part.inverted});
        } else {
            const std::uint32_t second = part.first + nodes[node.left].leaves;
            const bool both = node.step == condition_and;
            parts.push_back({node.left, part.first, both ? second : part.if_true,
                             both ? part.if_false : second, part.inverted});
            parts.push_back({node.right, second, part.if_true, part.if_false, part.inverted});
        }
    }
    return tests;
}

}  // namespace povpreview::items
