// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>

namespace povpreview {

/// How the program ends; the numbers are its exit codes.
enum class Exit {
    success = 0,
    scene = 1,         ///< the scene is at fault; POV-Ray's own message is passed on
    usage = 2,         ///< an option, a file or the machine is at fault
    tracer = 3,        ///< the tracer cannot go on
    interrupted = 130  ///< Ctrl-C
};

/// Something outside the program went wrong (a scene, a file, the tracer, GL). Shown to the user as
/// one message: what happened, where, and what to do about it.
class Error : public std::runtime_error {
   public:
    Error(Exit exit, const std::string& cause, const std::string& place, const std::string& remedy)
        : std::runtime_error(message(cause, place, remedy)), exit_(exit) {}
    Exit exit() const { return exit_; }

   private:
    static std::string message(const std::string& cause, const std::string& place,
                               const std::string& remedy) {
        return (place.empty() ? "" : place + ": ") + cause + (remedy.empty() ? "" : "; " + remedy);
    }
    Exit exit_;
};

}  // namespace povpreview
