// SPDX-License-Identifier: GPL-3.0-or-later
#include "fault_plan.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace spherewalk::practice {

namespace {

constexpr std::array kNames = {
    std::pair{FaultKind::DropBeforeExecuting, std::string_view("drop-before-executing")},
    std::pair{FaultKind::ExecuteThenDrop, std::string_view("execute-then-drop")},
    std::pair{FaultKind::ServiceUnavailable, std::string_view("service-unavailable")},
    std::pair{FaultKind::CutDownload, std::string_view("cut-download")},
    std::pair{FaultKind::ForgetIds, std::string_view("forget-ids")},
    std::pair{FaultKind::PreviewWithoutBoundary, std::string_view("preview-without-boundary")},
    std::pair{FaultKind::PreviewWrongLength, std::string_view("preview-wrong-length")},
    std::pair{FaultKind::PreviewStall, std::string_view("preview-stall")},
};

} // namespace

std::string_view name(FaultKind kind) {
    for (const auto& [known, spelled] : kNames) {
        if (known == kind) {
            return spelled;
        }
    }
    return "unknown";
}

void Fault::validate() const {
    if (skip < 0 || count < 1) {
        throw Error(
            ErrorKind::InvalidInput,
            text("A fault of the practice camera must skip 0 or more calls and happen at least once; it has "
                 "skip ",
                 skip, " and count ", count, "."));
    }
}

Fault faultOf(const JsonReader& reader) {
    Fault fault;
    const std::string spelled = reader.string("fault");
    const auto* const found = std::find_if(kNames.begin(), kNames.end(),
                                           [&](const auto& known) { return known.second == spelled; });
    if (found == kNames.end()) {
        reader.fail(text("there is no fault \"", printable(spelled), "\""));
    }
    fault.kind = found->first;
    if (!reader.isAbsent("on")) {
        fault.on = reader.string("on");
    }
    constexpr std::int64_t kMany = 1'000'000;
    fault.skip = reader.isAbsent("skip") ? 0 : static_cast<int>(reader.integer("skip", 0, kMany));
    fault.count = reader.isAbsent("count") ? 1 : static_cast<int>(reader.integer("count", 1, kMany));
    fault.byte = reader.isAbsent("byte") ? 0 : static_cast<std::uint64_t>(reader.integer("byte", 0));
    return fault;
}

void FaultPlan::arm(Fault fault) {
    fault.validate();
    const std::scoped_lock lock(m_mutex);
    m_armed.push_back(std::move(fault));
}

void FaultPlan::clear() {
    const std::scoped_lock lock(m_mutex);
    m_armed.clear();
}

std::optional<Fault> FaultPlan::take(FaultKind kind, std::string_view call) {
    const std::scoped_lock lock(m_mutex);
    for (auto fault = m_armed.begin(); fault != m_armed.end(); ++fault) {
        if (fault->kind != kind || !call.starts_with(fault->on)) {
            continue;
        }
        if (fault->skip > 0) {
            --fault->skip;
            continue;
        }
        const Fault taken = *fault;
        if (--fault->count == 0) {
            m_armed.erase(fault);
        }
        return taken;
    }
    return std::nullopt;
}

} // namespace spherewalk::practice
