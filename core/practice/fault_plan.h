// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/practice/fault.h"

#include <mutex>
#include <optional>
#include <vector>

namespace spherewalk::practice {

/// The fault that a JSON object spells: {"fault": name, "on": ..., "skip": ..., "count": ..., "byte": ...}.
/// Errors: Corrupt, InvalidInput.
Fault faultOf(const JsonReader& reader);

/// The faults still to come. Threads: any.
class FaultPlan {
  public:
    void arm(Fault fault);
    void clear();

    /// The fault of this kind that meets this call, counted down; nothing if there is none.
    std::optional<Fault> take(FaultKind kind, std::string_view call);

  private:
    std::mutex m_mutex;
    std::vector<Fault> m_armed;
};

} // namespace spherewalk::practice
