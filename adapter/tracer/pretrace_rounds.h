// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>

namespace povpreview::tracer {

/// Hands out the blocks of the image to the threads that pretrace radiosity, in rounds: what a
/// block gathers may be reused by those of later rounds, not by those of its own, which others
/// trace at the same time. So what is gathered does not depend on the number of threads, nor on
/// their speed.
///
///     step 0          |1|2|  3  |  4  |    5    |      6      |       7        | ...
///     step 1, 2, ...  |   1   |   2   |   3   |   4   | ...     blocks, in order
///
/// A step is a pass over all blocks with samples at half the distance of the last one. Blocks of
/// one round repeat what they all need, which is most at first: the first block finds nothing and
/// gathers what is seen from everywhere. So rounds begin with one block and grow with what is done.
class PretraceRounds {
   public:
    struct Turn {
        unsigned block;
        unsigned step;   ///< from 0
        unsigned round;  ///< from 0, over all steps
    };
    enum Answer { taken, wait, over };

    PretraceRounds(unsigned blocks, unsigned steps);

    /// The next block; `wait` where its round has not begun after a few milliseconds. Each block
    /// taken must be followed by done().
    Answer next(Turn& turn);
    void done();

   private:
    void begin_round();

    std::mutex mutex_;
    std::condition_variable begun_;
    const unsigned blocks_, steps_;
    unsigned step_ = 0, round_ = 0;
    unsigned next_ = 0, end_ = 0;  // blocks of the round not taken yet
    unsigned running_ = 0;         // taken and not done
};

}  // namespace povpreview::tracer
