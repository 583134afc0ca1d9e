// SPDX-License-Identifier: AGPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <new>

#include "display/address_space.h"
#include "display/program/compare.h"
#include "display/program/figures.h"
#include "display/program/interrupt.h"
#include "display/program/options.h"
#include "display/program/plan.h"
#include "display/program/preview.h"
#include "display/program/reference_batch.h"

int main(int argc, char** argv) {
    using namespace povpreview;
    try {
        const CommandLine command = read_command_line(argc, argv);
        if (!command.text.empty()) {
            fmt::print("{}", command.text);
            return 0;
        }
        require_address_space(address_space::preview, "the preview");
        catch_interrupts();
        return static_cast<int>(command.compare     ? compare(*command.compare)
                                : command.figures   ? figures(*command.figures)
                                : command.plan      ? plan(*command.plan)
                                : command.reference ? reference(*command.reference)
                                                    : preview(*command.preview));
    } catch (const Error& error) {
        fmt::print(stderr, "povpreview: {}\n", error.what());
        return static_cast<int>(error.exit());
    } catch (const std::bad_alloc&) {
        fmt::print(stderr,
                   "povpreview: there is no memory left; end other programs, or raise the "
                   "limit (ulimit -v)\n");
        return static_cast<int>(Exit::usage);
    } catch (const std::exception& error) {
        fmt::print(stderr, "povpreview: {}; please report it with the scene\n", error.what());
        return static_cast<int>(Exit::tracer);
    }
}
