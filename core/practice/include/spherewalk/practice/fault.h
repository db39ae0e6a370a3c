// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace spherewalk::practice {

/// What the practice camera can be told to do wrong.
enum class FaultKind {
    DropBeforeExecuting,    ///< reads the request, closes the connection, does nothing
    ExecuteThenDrop,        ///< does as told, closes the connection without an answer
    ServiceUnavailable,     ///< answers 503
    CutDownload,            ///< closes the connection at this byte of a file
    ForgetIds,              ///< no longer knows the ids given out so far
    PreviewWithoutBoundary, ///< sends a picture of the preview without its boundary
    PreviewWrongLength,     ///< states `byte` as the length of a picture of the preview
    PreviewStall,           ///< sends no more of the preview, and keeps the connection open
};

/// The kind's name in POST /practice/faults: "drop-before-executing", "execute-then-drop",
/// "service-unavailable", "cut-download", "forget-ids", "preview-without-boundary", "preview-wrong-length",
/// "preview-stall".
std::string_view name(FaultKind kind);

/// One thing that is to go wrong, `count` times, after `skip` calls that it could have met. For the preview,
/// each picture is a call.
struct Fault {
    FaultKind kind = FaultKind::DropBeforeExecuting;
    std::string on; ///< a command ("camera.takePicture") or path ("/osc/info", "/files"); empty: any request
    int skip = 0;
    int count = 1;
    std::uint64_t byte = 0; ///< CutDownload: so many bytes of the file are sent; PreviewWrongLength: stated

    /// Errors: InvalidInput for a negative skip or a count below 1.
    void validate() const;
};

} // namespace spherewalk::practice
