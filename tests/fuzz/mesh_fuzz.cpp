// SPDX-License-Identifier: AGPL-3.0-or-later
//
// A script of operations on a mesh, in any order, with every invariant checked after each.
#include "core/mesh.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/targets.h"

namespace povpreview::fuzz {
namespace {

constexpr int size = 16;                // pixels a side
constexpr std::size_t most_steps = 64;  // validation takes a time that grows with the mesh

class Script {
   public:
    explicit Script(std::span<const std::byte> bytes) : input_(bytes), mesh_(size, size) {}

    void run() {
        for (std::size_t i = 0; i < most_steps && !input_.empty(); ++i) {
            step();
            const std::string fault = mesh_.validate();
            promise(fault.empty(), fault);
            promise(mesh_.triangulation().sound(), "CGAL finds the triangulation unsound");
        }
        Picture picture;
        mesh_.draw(picture);
        promise(picture.corners.size() == 3 * mesh_.triangulation().faces(), "a corner is missing");
    }

   private:
    const Triangulation& triangulation() const { return mesh_.triangulation(); }

    VertexId vertex() {
        const std::size_t all = triangulation().vertex_ids();
        std::size_t i = input_.whole(all);
        while (!triangulation().alive(VertexId{static_cast<std::uint32_t>(i)})) i = (i + 1) % all;
        return VertexId{static_cast<std::uint32_t>(i)};
    }
    VertexId neighbour(VertexId of) {
        std::vector<Triangulation::Spoke> fan;
        triangulation().fan(of, fan);
        return fan[input_.whole(fan.size())].to;
    }

    void step() {
        switch (input_.whole(8)) {
            case 0:
            case 1:
                return sample(mesh_.insert(input_.inside(size), vertex()).vertex);
            case 2:
            case 3: {
                const VertexId a = vertex(), b = vertex();
                if (a != b) mesh_.constrain(a, b);
                return;
            }
            case 4:
                return split(.5);
            case 5:
                return split(input_.byte() / 255.);
            case 6: {
                const VertexId v = vertex();
                if (!triangulation().on_constraint(v) && !triangulation().on_border(v))
                    mesh_.remove(v);
                return;
            }
            default:
                return side(vertex());
        }
    }

    /// A vertex's own sample, which comes, fails, or never comes.
    void sample(VertexId at) {
        if (mesh_.first_sample(at).valid()) return;
        answer(mesh_.promise(at, triangulation().position(at)));
    }
    void answer(SampleId id) {
        const std::uint8_t how = input_.byte();
        if (how < 32) return;
        if (how < 64) return mesh_.fail(id);
        Sample sample;
        sample.position = mesh_.sample(id).position;
        sample.colour = glm::vec3(how, how / 2, how % 7) / 128.F;
        sample.surface = how % 5;
        mesh_.answer(id, sample);
    }
    void side(VertexId at) {
        std::vector<Mesh::MissingSide> missing;
        mesh_.missing_sides(at, missing);
        if (missing.empty()) return;
        const auto id = mesh_.promise_side(at, missing[input_.whole(missing.size())].side);
        if (id) answer(*id);
    }
    /// Of a constrained edge, at a share of its length, as rounding will have it.
    void split(double share) {
        const VertexId a = vertex(), b = neighbour(a);
        Triangulation::Edge edge{};
        if (!triangulation().find_edge(a, b, edge) || !edge.constrained) return;
        const glm::dvec2 p = triangulation().position(a), q = triangulation().position(b);
        sample(mesh_.split(a, b, p + share * (q - p)).vertex);
    }

    Input input_;
    Mesh mesh_;
};

}  // namespace

void mesh(std::span<const std::byte> bytes) { Script(bytes).run(); }

}  // namespace povpreview::fuzz
