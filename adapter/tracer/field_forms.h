// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace pov {
class Blob;
class Superellipsoid;
}  // namespace pov

/// Forms of surfaces where a field has a given value; each returns null, or why there is none.
namespace povpreview::tracer {

class Builder;

const char* add(const pov::Superellipsoid& ellipsoid, Builder& build);
const char* add(const pov::Blob& blob, Builder& build);

}  // namespace povpreview::tracer
