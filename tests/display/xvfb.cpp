// SPDX-License-Identifier: AGPL-3.0-or-later
#include "tests/display/xvfb.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

namespace povpreview::test {

namespace {

/// The number of the display that the server chose, or "" if it ended or took too long.
std::string display_number(int descriptor) {
    std::string number;
    pollfd ready{descriptor, POLLIN, 0};
    char letter;
    while (::poll(&ready, 1, 20000) == 1 && ::read(descriptor, &letter, 1) == 1) {
        if (letter == '\n') return number;
        number += letter;
    }
    return "";
}

}  // namespace

Xvfb::Xvfb() {
    int ends[2];
    if (::pipe(ends) < 0) {
        why_not_ = "no pipe";
        return;
    }
    const std::string descriptor = std::to_string(ends[1]);
    server_ = ::fork();
    if (server_ == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM);
        ::close(ends[0]);
        const int nowhere = ::open("/dev/null", O_WRONLY);
        ::dup2(nowhere, 2);
        ::execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1400x1000x24",
                 "-nolisten", "tcp", nullptr);
        ::_exit(127);
    }
    ::close(ends[1]);
    const std::string number = server_ > 0 ? display_number(ends[0]) : "";
    ::close(ends[0]);
    if (number.empty())
        why_not_ = "Xvfb does not start";
    else
        ::setenv("DISPLAY", (":" + number).c_str(), 1);
}

Xvfb::~Xvfb() {
    if (server_ <= 0) return;
    ::kill(server_, SIGTERM);
    ::waitpid(server_, nullptr, 0);
    ::unsetenv("DISPLAY");
}

}  // namespace povpreview::test
