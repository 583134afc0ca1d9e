// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/interrupt.h"

#include <signal.h>

namespace povpreview {
namespace {

volatile sig_atomic_t flag = 0;

}  // namespace

void catch_interrupts() {
    struct sigaction action {};
    action.sa_handler = [](int) { flag = 1; };
    action.sa_flags = static_cast<int>(SA_RESETHAND);
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return flag != 0; }

}  // namespace povpreview
