// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/simulator/refusals.h"

#include "spherewalk/base/enum_names.h"
#include "spherewalk/base/text.h"

#include <utility>

namespace spherewalk::simulator {

namespace {

constexpr EnumNames<Refusal, kRefusalKinds> kRefusalNames{{{Refusal::Place, "place"},
                                                           {Refusal::Rotation, "rotation"},
                                                           {Refusal::Time, "time"},
                                                           {Refusal::FrameId, "frame_id"},
                                                           {Refusal::Size, "size"},
                                                           {Refusal::Encoding, "encoding"},
                                                           {Refusal::Rendering, "rendering"}}};

bool isPowerOfTen(std::uint64_t number) {
    while (number % 10 == 0) {
        number /= 10;
    }
    return number == 1;
}

} // namespace

std::string_view name(Refusal kind) {
    return nameOf(kRefusalNames, kind);
}

Refusals::Refusals(Tell tell) : m_tell(std::move(tell)) {
}

void Refusals::add(Refusal kind, const std::string& sentence) {
    const std::scoped_lock lock(m_mutex);
    const std::uint64_t count = ++m_counts[static_cast<std::size_t>(kind)];
    if (isPowerOfTen(count)) {
        m_tell(count == 1 ? sentence : text(sentence, " (", count, " of this kind so far)"));
    }
}

Refusals::Counts Refusals::counts() const {
    const std::scoped_lock lock(m_mutex);
    return m_counts;
}

} // namespace spherewalk::simulator
