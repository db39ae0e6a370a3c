// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/practice/fault.h"

#include <initializer_list>
#include <mutex>
#include <optional>
#include <vector>

namespace spherewalk::practice {

/// The fault in a JSON object: {"fault": name, "on": ..., "skip": ..., "count": ..., "byte": ...,
/// "amount": ..., "code": ...}. Errors: Corrupt, InvalidInput.
Fault faultOf(const JsonReader& reader);

/// True for troubles of the camera itself, false for those of requests.
bool isOfCamera(FaultKind kind);

/// The faults that wait for their calls. Threads: any.
class FaultPlan {
  public:
    /// Errors: those of Fault::validate().
    void arm(Fault fault);
    void clear();

    /// The first fault of this kind that meets the call. It is counted down. Returns nothing if no fault
    /// meets it.
    std::optional<Fault> take(FaultKind kind, std::string_view call);
    /// The same for several kinds.
    std::optional<Fault> take(std::initializer_list<FaultKind> kinds, std::string_view call);
    /// All troubles of the camera itself that meet the call; each is counted down.
    std::vector<Fault> takeOfCamera(std::string_view call);

  private:
    template <class Match>
    std::optional<Fault> takeFirst(const Match& matches, std::string_view call);

    std::mutex m_mutex;
    std::vector<Fault> m_armed;
};

} // namespace spherewalk::practice
