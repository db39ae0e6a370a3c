// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace spherewalk::simulator {

/// Why something that came from outside was not used.
enum class Refusal {
    Place,     ///< a position that is not finite, or farther than 10^7 m
    Rotation,  ///< a quaternion that is not finite or not of unit length
    Time,      ///< a time before zero, or none
    FrameId,   ///< a pose of another frame than the one that was asked for, or one that leads nowhere
    Size,      ///< a picture of another size than the camera, or with too few bytes
    Encoding,  ///< pixels of a kind that this picture cannot have
    Rendering, ///< a frame that could not be made: a photo is missing or damaged
};

inline constexpr std::size_t kRefusalKinds = 7;

/// As reports spell it: "place", "rotation", ...
std::string_view name(Refusal kind);

/// Counts what was refused, and tells people of the first of each kind and then of the 10th, 100th, ... so
/// that a publisher of garbage cannot fill a log. Threads: any.
class Refusals {
  public:
    using Tell = std::function<void(const std::string& sentence)>;
    using Counts = std::array<std::uint64_t, kRefusalKinds>;

    /// tell: called from whichever thread refuses, one at a time.
    explicit Refusals(Tell tell);

    void add(Refusal kind, const std::string& sentence);

    /// Index: the kinds in their order.
    Counts counts() const;

  private:
    Tell m_tell;
    mutable std::mutex m_mutex;
    Counts m_counts{};
};

} // namespace spherewalk::simulator
