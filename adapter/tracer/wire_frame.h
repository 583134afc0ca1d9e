// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "backend/oracle/point.h"
#include "backend/oracle/wire_generated.h"

/// What all messages of the wire have in common.
namespace povpreview::tracer {

/// A message with its length in front, ready to be written.
using WireFrame = std::vector<std::uint8_t>;

template <typename Message>
WireFrame wire_frame(flatbuffers::FlatBufferBuilder& builder, wire::Report kind,
                     flatbuffers::Offset<Message> message) {
    builder.Finish(wire::CreateToPreviewer(builder, kind, message.Union()), "PVPR");
    // Not FinishSizePrefixed: that aligns the buffer as if it were read together with its size.
    const std::uint32_t size = builder.GetSize();
    WireFrame frame;
    frame.reserve(size + 4);
    for (int shift = 0; shift < 32; shift += 8)
        frame.push_back(static_cast<std::uint8_t>(size >> shift));
    frame.insert(frame.end(), builder.GetBufferPointer(), builder.GetBufferPointer() + size);
    return frame;
}

inline wire::Vec3d vec3d(const Point& p) { return {p.x, p.y, p.z}; }

}  // namespace povpreview::tracer
