// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace povpreview::tracer {

/// A task of POV-Ray's that says so runs beside all others: a sync of the queue does not wait for
/// it to end.
class BesideTask {
   public:
    virtual ~BesideTask() = default;
    virtual bool is_beside() const { return true; }
};

}  // namespace povpreview::tracer
