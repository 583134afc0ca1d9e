// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <string>

namespace povpreview::test {

/// An X server without a screen, and DISPLAY pointing to it, for as long as this lives.
class Xvfb {
   public:
    Xvfb();
    Xvfb(const Xvfb&) = delete;
    Xvfb& operator=(const Xvfb&) = delete;
    ~Xvfb();

    /// Why it does not run; empty if it does.
    const std::string& why_not() const { return why_not_; }

   private:
    pid_t server_ = -1;
    std::string why_not_;
};

}  // namespace povpreview::test
