// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace pov {
class Lathe;
class Prism;
class Sor;
class TrueType;
}  // namespace pov

/// Closed forms of what is made of curves in a plane; each returns null, or why it has none.
namespace povpreview::tracer {

class Builder;

/// Swept along y between two heights; a conic one grows with the height.
const char* add(const pov::Prism& prism, Builder& build);
/// A letter, swept along z from 0 on.
const char* add(const pov::TrueType& letter, Builder& build);
/// Turned around y.
const char* add(const pov::Lathe& lathe, Builder& build);
const char* add(const pov::Sor& sor, Builder& build);

}  // namespace povpreview::tracer
