// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/progress_line.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace povpreview::test {
namespace {

using namespace std::chrono_literals;

/// A terminal of our own, `columns` wide.
class Terminal {
   public:
    explicit Terminal(unsigned short columns) : master_(::posix_openpt(O_RDWR | O_NOCTTY)) {
        EXPECT_EQ(::grantpt(master_), 0);
        EXPECT_EQ(::unlockpt(master_), 0);
        slave_ = ::open(::ptsname(master_), O_RDWR | O_NOCTTY);
        winsize size{};
        size.ws_col = columns;
        size.ws_row = 24;
        EXPECT_EQ(::ioctl(slave_, TIOCSWINSZ, &size), 0);
        EXPECT_EQ(::fcntl(master_, F_SETFL, O_NONBLOCK), 0);
    }
    Terminal(const Terminal&) = delete;
    Terminal& operator=(const Terminal&) = delete;
    ~Terminal() {
        ::close(slave_);
        ::close(master_);
    }
    int descriptor() const { return slave_; }
    /// What was written since the last call.
    std::string read() {
        char part[4096];
        const ssize_t got = ::read(master_, part, sizeof part);
        return got > 0 ? std::string(part, static_cast<std::size_t>(got)) : "";
    }

   private:
    int master_, slave_;
};

TEST(ProgressLine, WritesOverItselfAndClearsAtTheEnd) {
    Terminal terminal(80);
    {
        ProgressLine line(terminal.descriptor());
        line.show("first");
        EXPECT_EQ(terminal.read(), "\rfirst\x1b[K");
    }
    EXPECT_EQ(terminal.read(), "\r\x1b[K");
}

TEST(ProgressLine, AtMostTenTimesASecond) {
    Terminal terminal(80);
    ProgressLine line(terminal.descriptor());
    const auto start = ProgressLine::Clock::now();
    int written = 0;
    for (int ms = 0; ms < 1000; ++ms) {
        line.show("x", start + ms * 1ms);
        written += !terminal.read().empty();
    }
    EXPECT_EQ(written, 10);
}

TEST(ProgressLine, IsCutToTheTerminal) {
    Terminal terminal(10);
    ProgressLine line(terminal.descriptor());
    line.show("0123456789abc");
    EXPECT_EQ(terminal.read(), "\r012345678\x1b[K");
    line.clear();
    terminal.read();
    line.show("\xC3\xA4\xC3\xB6\xC3\xBC-456789abc");  // letters of two bytes are not cut in half
    EXPECT_EQ(terminal.read(), "\r\xC3\xA4\xC3\xB6\xC3\xBC-45678\x1b[K");
}

TEST(ProgressLine, IsQuietWhereThereIsNoTerminal) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    {
        ProgressLine line(ends[1]);
        line.show("nobody reads this");
        line.clear();
    }
    ::close(ends[1]);
    char byte;
    EXPECT_EQ(::read(ends[0], &byte, 1), 0) << "the pipe must be empty";
    ::close(ends[0]);
}

TEST(ProgressLine, WithoutAShowThereIsNothingToClear) {
    Terminal terminal(80);
    { ProgressLine line(terminal.descriptor()); }
    EXPECT_EQ(terminal.read(), "");
}

TEST(Progress, Sentences) {
    EXPECT_EQ(sentence({"refining", 12345, 307200, 133000, 12s}),
              "refining  12,345 samples (4.02 % of pixels)  133,000/s  0:12");
    EXPECT_EQ(sentence({"parsing", 0, 0, 0, 3661s}), "parsing  0 samples  1:01:01");
    EXPECT_EQ(sentence({"filling", 1000000, 1000000, 999.6, 59.9s}),
              "filling  1,000,000 samples (100 % of pixels)  1,000/s  0:59");
}

}  // namespace
}  // namespace povpreview::test
