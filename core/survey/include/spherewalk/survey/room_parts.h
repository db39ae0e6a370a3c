// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/survey/plan.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::survey {

/// Tells to which of a flat's named rooms a place belongs: to the nearest name that the place sees over free
/// floor, or else to the one that is the shortest walk away. Threads: const functions may be called from any.
class RoomParts {
  public:
    /// Range: the room is valid.
    explicit RoomParts(const Room& room);
    ~RoomParts();
    RoomParts(RoomParts&&) noexcept;
    RoomParts& operator=(RoomParts&&) noexcept;

    /// The names of the rooms, each once, as the plan lists them.
    const std::vector<std::string>& names() const;

    /// The index of the place's room in names(); nothing in a plan without names.
    std::optional<std::size_t> at(const Eigen::Vector2d& place) const;

    /// The index of the room of each rail in names(), by the rail's middle; empty without names.
    std::vector<std::size_t> ofRails(const Plan& plan) const;

  private:
    struct Places;
    std::unique_ptr<Places> m_places;
};

/// The plan with its rails room by room: all rails of the room in which it begins, then all of the room that
/// comes next, and so on. Within a room the rails keep their order. A plan without names stays as it is.
Plan roomByRoom(Plan plan, const Room& room);

} // namespace spherewalk::survey
