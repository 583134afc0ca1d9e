// SPDX-License-Identifier: AGPL-3.0-or-later
#include "display/program/session_samples.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace povpreview {
namespace {

/// The first byte of a sample: kind, parts, failed.
constexpr unsigned parts_shift = 2, failed_bit = 1u << 5, all_bits = (1u << 6) - 1;

/// Visits a sample's values in the order in which they are stored.
template <class SampleOrConst, class Visit>
void visit(SampleOrConst& sample, const Visit& value) {
    const Parts parts = sample.parts;
    const bool full = sample.kind == RayKind::full;
    value(sample.position);
    value(sample.cost_ns);
    if (sample.failed) return;
    if (full) {
        value(sample.colour);
        value(sample.transmittance);
    }
    if (!full || contains(parts, Parts::surface)) {
        value(sample.surface);
        value(sample.reflected_surface);
        value(sample.depth);
        value(sample.normal);
    }
    if (sample.kind == RayKind::albedo || (full && contains(parts, Parts::shading)))
        value(sample.albedo);
    if (full && contains(parts, Parts::shading)) {
        value(sample.illumination);
        value(sample.remainder);
    }
    if (sample.kind == RayKind::probe || (full && contains(parts, Parts::signature)))
        value(sample.signature);
}

}  // namespace

void encode_sample(std::string& bytes, const Sample& sample) {
    const unsigned head = static_cast<unsigned>(sample.kind) |
                          static_cast<unsigned>(sample.parts) << parts_shift |
                          (sample.failed ? failed_bit : 0);
    bytes.push_back(static_cast<char>(head));
    visit(sample, [&](const auto& value) {
        static_assert(std::is_trivially_copyable_v<std::remove_reference_t<decltype(value)>>);
        bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
    });
}

bool decode_samples(std::string_view bytes, const std::function<void(const Sample&)>& each) {
    while (!bytes.empty()) {
        const auto head = static_cast<unsigned char>(bytes.front());
        bytes.remove_prefix(1);
        Sample sample;
        const unsigned kind = head & 3;
        if (head > all_bits || kind > static_cast<unsigned>(RayKind::albedo)) return false;
        sample.kind = static_cast<RayKind>(kind);
        sample.failed = (head & failed_bit) != 0;
        sample.parts = static_cast<Parts>(head >> parts_shift & 7);
        bool whole = true;
        visit(sample, [&](auto& value) {
            whole = whole && bytes.size() >= sizeof value;
            if (!whole) return;
            std::memcpy(&value, bytes.data(), sizeof value);
            bytes.remove_prefix(sizeof value);
        });
        if (!whole) return false;
        each(sample);
    }
    return true;
}

}  // namespace povpreview
