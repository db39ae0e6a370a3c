// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random.h"

#include "spherewalk/survey/room.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace spherewalk::survey::test {

/// Builds flats: rectangular rooms behind each other's doorways, in one outline that goes round all of them.
class FlatBuilder {
  public:
    explicit FlatBuilder(spherewalk::test::Random& random) : m_random(random) {}

    Room build() {
        const double width = m_random.uniform(2.5, 6);
        const double depth = m_random.uniform(2.5, 5);
        m_room.outline = {{0, 0}, {width, 0}, {width, depth}, {0, depth}};
        m_room.ceilingM = 2.6;
        m_floors = {bounds(m_room.outline)};
        const auto wanted = static_cast<std::size_t>(m_random.integer(2, 5));
        for (int tries = 0; tries < 60 && m_floors.size() < wanted; ++tries) {
            addRoom();
        }
        for (const Bounds2& floor : m_floors) {
            furnish(floor);
        }
        return m_room;
    }

    std::size_t rooms() const { return m_floors.size(); }

  private:
    static constexpr double kThinnestM = 0.08;
    static constexpr double kThickestM = 0.30;

    /// Adds a room behind a doorway in a random wall, where there is space.
    void addRoom() {
        const std::size_t n = m_room.outline.size();
        const auto wall = static_cast<std::size_t>(m_random.integer(0, static_cast<int>(n) - 1));
        const Eigen::Vector2d a = m_room.outline[wall];
        const Eigen::Vector2d b = m_room.outline[(wall + 1) % n];
        const double doorM = m_random.uniform(0.7, 1.0);
        const double leftM = (b - a).norm() - doorM;
        if (leftM < 0.3) {
            return;
        }
        const Eigen::Vector2d along = (b - a).normalized();
        const Eigen::Vector2d outwards(along.y(), -along.x());
        const double thickM = m_random.uniform(kThinnestM, kThickestM);
        const Eigen::Vector2d p1 = a + m_random.uniform(0.1, leftM - 0.1) * along;
        const Eigen::Vector2d p2 = p1 + doorM * along;
        const Eigen::Vector2d in1 = p1 + thickM * outwards;
        const Eigen::Vector2d in2 = p2 + thickM * outwards;
        const Eigen::Vector2d left = in1 - m_random.uniform(0.15, 3) * along;
        const Eigen::Vector2d right = in2 + m_random.uniform(0.15, 3) * along;
        const Eigen::Vector2d deep = m_random.uniform(1.6, 5) * outwards;
        const Bounds2 floor = bounds({left, right, left + deep, right + deep});
        if (!isFree(floor)) {
            return;
        }
        const Polygon behind{p1, in1, left, left + deep, right + deep, right, in2, p2};
        m_room.outline.insert(m_room.outline.begin() + static_cast<std::ptrdiff_t>(wall) + 1, behind.begin(),
                              behind.end());
        m_floors.push_back(floor);
    }

    /// Whether a wall of at least kThinnestM fits between this floor and all others.
    bool isFree(const Bounds2& floor) const {
        const double wall = kThinnestM - 1e-6;
        return std::all_of(m_floors.begin(), m_floors.end(), [&](const Bounds2& other) {
            return ((floor.least - other.greatest).array() >= wall).any() ||
                   ((other.least - floor.greatest).array() >= wall).any();
        });
    }

    /// Puts some boxes into a room, away from its walls and doorways or not.
    void furnish(const Bounds2& floor) {
        for (int i = m_random.integer(0, 2); i > 0; --i) {
            const Eigen::Vector2d size(m_random.uniform(0.3, 1), m_random.uniform(0.3, 1));
            const Eigen::Array2d space = (floor.greatest - floor.least - size).array();
            if ((space <= 0).any()) {
                continue;
            }
            const Eigen::Vector2d at =
                floor.least + Eigen::Vector2d(m_random.uniform(0, space.x()), m_random.uniform(0, space.y()));
            m_room.obstacles.push_back(
                {at, at + Eigen::Vector2d(size.x(), 0), at + size, at + Eigen::Vector2d(0, size.y())});
        }
    }

    spherewalk::test::Random& m_random;
    Room m_room;
    std::vector<Bounds2> m_floors;
};

} // namespace spherewalk::survey::test
