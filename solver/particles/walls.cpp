// SPDX-License-Identifier: BSD-3-Clause
#include "solver/particles/walls.hpp"

#include "solver/core/errors.hpp"

namespace wetdeck {

void WallParticles::add(Vec2 position, Vec2 normal, double its_fineness) {
    if (fixed != size()) throw InputError("tank walls must be added before bodies");
    ++fixed;
    append_particle(*this);
    state.back() = {position.x(), position.y(), 0, 0, normal.x(), normal.y(), 0, 0};
    fineness.back() = its_fineness;
    id.back() = static_cast<std::uint32_t>(id.size() - 1);
}

void WallParticles::add_body_point(std::uint32_t body, Vec2 position, Vec2 normal) {
    append_particle(*this);
    body_point.back() = {position.x(), position.y(), normal.x(), normal.y(), body};
    fineness.back() = 1;
    id.back() = static_cast<std::uint32_t>(id.size() - 1);
}

}  // namespace wetdeck
