// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <string_view>

namespace spherewalk::simulator {

/// Why some input was not used.
enum class Refusal {
    Place,     ///< The position is not finite, or farther than 10^7 m.
    Rotation,  ///< The quaternion is not finite or has not unit length.
    Time,      ///< The time is missing or before zero.
    FrameId,   ///< The pose is of another frame than the wanted one, or of an unknown one.
    Size,      ///< The picture has another size than the camera, or too few bytes.
    Encoding,  ///< This picture cannot have pixels of this kind.
    Rendering, ///< A frame could not be made, because a photo is missing or damaged.
};

inline constexpr std::size_t kRefusalKinds = 7;

/// The kind as reports spell it: "place", "rotation", ...
std::string_view name(Refusal kind);

/// Counts refusals. Of each kind, people are told of the first, the 10th, the 100th and so on, so that a
/// publisher of garbage cannot fill a log. Threads: any.
class Refusals {
  public:
    using Tell = std::function<void(const std::string& sentence)>;
    using Counts = std::array<std::uint64_t, kRefusalKinds>;

    /// tell: is called by the thread that refuses, one thread at a time.
    explicit Refusals(Tell tell);

    void add(Refusal kind, const std::string& sentence);

    /// The count of each kind, in the order of Refusal.
    Counts counts() const;

  private:
    Tell m_tell;
    mutable std::mutex m_mutex;
    Counts m_counts{};
};

} // namespace spherewalk::simulator
