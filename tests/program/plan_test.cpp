// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/plan.h"

#include <gtest/gtest.h>

namespace povpreview {
namespace {

TEST(PlanTable, TellsWhatRunsWhatIsLeftOutAndWhy) {
    Stage runs{.name = "filling", .runs = true, .why = "the rest"};
    runs.expected = .9583;
    runs.rays = 70000;
    Stage left_out{.name = "albedo rays", .runs = false, .why = "too dear"};
    const std::string table = plan_table({runs, left_out}, false);
    EXPECT_NE(table.find("filling              runs        95.8 %  the rest\n"), std::string::npos)
        << table;
    EXPECT_NE(table.find("albedo rays          left out         ?  too dear\n"), std::string::npos)
        << table;
    EXPECT_EQ(table.find("70000"), std::string::npos) << "nothing was taken yet";
    EXPECT_NE(plan_table({runs}, true).find("70000"), std::string::npos);
}

}  // namespace
}  // namespace povpreview
