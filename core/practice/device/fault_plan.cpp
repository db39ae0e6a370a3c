// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/fault_plan.h"

#include "device/osc_protocol.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace spherewalk::practice {

namespace {

constexpr std::array kFaultNames = {
    std::pair{FaultKind::NeverAnswer, std::string_view("never-answer")},
    std::pair{FaultKind::DropAfterHeader, std::string_view("drop-after-header")},
    std::pair{FaultKind::DropBeforeExecuting, std::string_view("drop-before-executing")},
    std::pair{FaultKind::ExecuteThenDrop, std::string_view("execute-then-drop")},
    std::pair{FaultKind::ServiceUnavailable, std::string_view("service-unavailable")},
    std::pair{FaultKind::Refuse, std::string_view("refuse")},
    std::pair{FaultKind::EmptyBody, std::string_view("empty-body")},
    std::pair{FaultKind::WebPage, std::string_view("web-page")},
    std::pair{FaultKind::MalformedJson, std::string_view("malformed-json")},
    std::pair{FaultKind::TruncatedJson, std::string_view("truncated-json")},
    std::pair{FaultKind::ShortLength, std::string_view("short-length")},
    std::pair{FaultKind::LongLength, std::string_view("long-length")},
    std::pair{FaultKind::Chunked, std::string_view("chunked")},
    std::pair{FaultKind::ForgetIds, std::string_view("forget-ids")},
    std::pair{FaultKind::StuckInProgress, std::string_view("stuck-in-progress")},
    std::pair{FaultKind::DoneWithoutUrl, std::string_view("done-without-url")},
    std::pair{FaultKind::UrlOfOtherHost, std::string_view("url-of-other-host")},
    std::pair{FaultKind::EmptyPhoto, std::string_view("empty-photo")},
    std::pair{FaultKind::SmallPhoto, std::string_view("small-photo")},
    std::pair{FaultKind::NoMakerNote, std::string_view("no-maker-note")},
    std::pair{FaultKind::HostileMakerNote, std::string_view("hostile-maker-note")},
    std::pair{FaultKind::MissingFile, std::string_view("missing-file")},
    std::pair{FaultKind::CutDownload, std::string_view("cut-download")},
    std::pair{FaultKind::StallDownload, std::string_view("stall-download")},
    std::pair{FaultKind::CorruptDownload, std::string_view("corrupt-download")},
    std::pair{FaultKind::PreviewWithoutBoundary, std::string_view("preview-without-boundary")},
    std::pair{FaultKind::PreviewWrongLength, std::string_view("preview-wrong-length")},
    std::pair{FaultKind::PreviewStall, std::string_view("preview-stall")},
    std::pair{FaultKind::RefuseConnections, std::string_view("refuse-connections")},
    std::pair{FaultKind::Sleep, std::string_view("sleep")},
    std::pair{FaultKind::Reboot, std::string_view("reboot")},
    std::pair{FaultKind::StorageFull, std::string_view("storage-full")},
    std::pair{FaultKind::Battery, std::string_view("battery")},
    std::pair{FaultKind::Hot, std::string_view("hot")},
    std::pair{FaultKind::ResetSettings, std::string_view("reset-settings")},
    std::pair{FaultKind::ExtraPhoto, std::string_view("extra-photo")},
    std::pair{FaultKind::ClockUnset, std::string_view("clock-unset")},
    std::pair{FaultKind::OtherSerial, std::string_view("other-serial")},
    std::pair{FaultKind::LevelOne, std::string_view("level-one")},
    std::pair{FaultKind::Plugin, std::string_view("plugin")},
    std::pair{FaultKind::RestartCounter, std::string_view("restart-counter")},
    std::pair{FaultKind::UnknownValues, std::string_view("unknown-values")},
    std::pair{FaultKind::Slow, std::string_view("slow")},
    std::pair{FaultKind::StaleNonce, std::string_view("stale-nonce")},
    std::pair{FaultKind::NoMoreTrouble, std::string_view("no-more-trouble")},
};

} // namespace

std::string_view name(FaultKind kind) {
    for (const auto& [known, spelled] : kFaultNames) {
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
    if (!(amount >= 0 && amount <= 1000)) {
        throw Error(ErrorKind::InvalidInput,
                    text("The amount of a fault of the practice camera must lie between 0 and 1000, not ",
                         amount, "."));
    }
    if (!code.empty() && !oscCode(code)) {
        throw Error(ErrorKind::InvalidInput, text("The practice camera has no error code \"", printable(code),
                                                  "\"; one is deviceBusy."));
    }
}

bool isOfCamera(FaultKind kind) {
    return kind >= FaultKind::RefuseConnections;
}

Fault faultOf(const JsonReader& reader) {
    Fault fault;
    const std::string spelled = reader.string("fault");
    const auto* const found = std::find_if(kFaultNames.begin(), kFaultNames.end(),
                                           [&](const auto& known) { return known.second == spelled; });
    if (found == kFaultNames.end()) {
        reader.fail(text("there is no fault \"", printable(spelled), "\""));
    }
    fault.kind = found->first;
    if (!reader.isAbsent("on")) {
        fault.on = reader.string("on");
    }
    constexpr std::int64_t kMany = 1'000'000;
    fault.skip = reader.isAbsent("skip") ? 0 : static_cast<int>(reader.integer("skip", 0, kMany));
    fault.count = reader.isAbsent("count") ? 1 : static_cast<int>(reader.integer("count", 1, kMany));
    fault.amount = reader.isAbsent("amount") ? 0 : reader.number("amount");
    fault.code = reader.isAbsent("code") ? std::string() : reader.string("code");
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

template <class Match>
std::optional<Fault> FaultPlan::takeFirst(const Match& matches, std::string_view call) {
    const std::scoped_lock lock(m_mutex);
    for (auto fault = m_armed.begin(); fault != m_armed.end(); ++fault) {
        if (!matches(fault->kind) || !call.starts_with(fault->on)) {
            continue;
        }
        if (fault->skip > 0) {
            --fault->skip;
            continue;
        }
        Fault taken = *fault;
        if (--fault->count == 0) {
            m_armed.erase(fault);
        }
        return taken;
    }
    return std::nullopt;
}

std::optional<Fault> FaultPlan::take(FaultKind kind, std::string_view call) {
    return takeFirst([kind](FaultKind other) { return other == kind; }, call);
}

std::optional<Fault> FaultPlan::take(std::initializer_list<FaultKind> kinds, std::string_view call) {
    return takeFirst(
        [&](FaultKind kind) { return std::find(kinds.begin(), kinds.end(), kind) != kinds.end(); }, call);
}

std::vector<Fault> FaultPlan::takeOfCamera(std::string_view call) {
    const std::scoped_lock lock(m_mutex);
    std::vector<Fault> taken;
    for (Fault& fault : m_armed) {
        if (!isOfCamera(fault.kind) || !call.starts_with(fault.on)) {
            continue;
        }
        if (fault.skip > 0) {
            --fault.skip;
            continue;
        }
        --fault.count;
        taken.push_back(fault);
    }
    std::erase_if(m_armed, [](const Fault& fault) { return fault.count == 0; });
    return taken;
}

} // namespace spherewalk::practice
