// SPDX-License-Identifier: AGPL-3.0-or-later
#include "adapter/stock_povray.h"

#include <gtest/gtest.h>

namespace povpreview {
namespace {

TEST(ReasonOfFailure, IsTheLastErrorWithoutItsLineBreaks) {
    EXPECT_EQ(reason_of_failure(
                  "==== [Parsing...] ====\n"
                  "File 'a.pov' line 4: Parse Error: No matching } in 'sphere', undeclared\n"
                  " identifier 'nonsense' found instead\n"
                  "Fatal error in parser: Cannot parse input.\nRender failed\n\n"),
              "File 'a.pov' line 4: Parse Error: No matching } in 'sphere', undeclared identifier "
              "'nonsense' found instead");
}

TEST(ReasonOfFailure, AlsoWhereTheBreakStandsInTheMiddleOfIt) {
    EXPECT_EQ(
        reason_of_failure("File '/long/a.pov' line 20: Possible Parse Error: Cannot find file\n"
                          " 'x.inc'.\n"
                          "File '/long/a.pov' line 20: Parse\n Error: Cannot open x.inc.\n"),
        "File '/long/a.pov' line 20: Parse Error: Cannot open x.inc.");
}

TEST(ReasonOfFailure, WithoutAnErrorItIsTheLastThingSaid) {
    EXPECT_EQ(reason_of_failure("one\ntwo\n\n"), "two");
    EXPECT_EQ(reason_of_failure(""), "");
}

}  // namespace
}  // namespace povpreview
