// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "adapter/wire.h"
#include "adapter/wire_generated.h"

/// Values of the wire, checked, as ours; for those who decode it.
namespace povpreview {

report::GeometryChunk decode_geometry(const wire::Geometry& from);
report::Texels decode_texels(const wire::Texels& from);

namespace wire_values {

inline glm::vec3 vec3(const wire::Vec3f& v) { return {v.x(), v.y(), v.z()}; }
inline glm::dvec3 vec3(const wire::Vec3d& v) { return {v.x(), v.y(), v.z()}; }
/// Absent struct fields read as zero, like absent numbers.
template <class V>
auto vec3(const V* v) {
    return v ? vec3(*v) : decltype(vec3(*v))(0);
}
inline std::string text(const flatbuffers::String* s) { return s ? s->str() : std::string(); }

/// The enumerator of ours that stands for one of the wire's; both lists run alike from 0.
template <class Ours, class Wires>
Ours enumerator(Wires value, Wires last, const char* what) {
    if (value > last)
        throw WireFault(fmt::format("an unknown {} ({})", what, static_cast<unsigned>(value)));
    return static_cast<Ours>(value);
}

/// Entries of a list in a scene; entries can share their content, so the size of the frame alone
/// does not bound what they unpack to.
constexpr std::size_t max_lights = std::size_t{1} << 17, max_kinds = 4096, max_files = 65536,
                      max_name = 256;

template <class List>
void check_list(const List* list, std::size_t limit, const char* what) {
    if (list && list->size() > limit)
        throw WireFault(fmt::format("a scene of {} {}", list->size(), what));
}
inline std::string name(const flatbuffers::String* s) {
    if (s && s->size() > max_name)
        throw WireFault(fmt::format("a name of {} characters", s->size()));
    return text(s);
}

}  // namespace wire_values
}  // namespace povpreview
