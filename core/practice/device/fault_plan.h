// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/practice/fault.h"

#include <initializer_list>
#include <mutex>
#include <optional>
#include <vector>

namespace spherewalk::practice {

/// The fault that a JSON object spells: {"fault": name, "on": ..., "skip": ..., "count": ..., "byte": ...,
/// "amount": ..., "code": ...}. Errors: Corrupt, InvalidInput.
Fault faultOf(const JsonReader& reader);

/// True for what happens to the camera itself rather than to a request.
bool isOfCamera(FaultKind kind);

/// The faults still to come. Threads: any.
class FaultPlan {
  public:
    /// Errors: those of Fault::validate().
    void arm(Fault fault);
    void clear();

    /// The fault of this kind that meets this call, counted down; nothing if there is none.
    std::optional<Fault> take(FaultKind kind, std::string_view call);
    /// The same of any of these kinds.
    std::optional<Fault> take(std::initializer_list<FaultKind> kinds, std::string_view call);
    /// All that happen to the camera itself at this call.
    std::vector<Fault> takeOfCamera(std::string_view call);

  private:
    template <class Match>
    std::optional<Fault> takeFirst(const Match& matches, std::string_view call);

    std::mutex m_mutex;
    std::vector<Fault> m_armed;
};

} // namespace spherewalk::practice
