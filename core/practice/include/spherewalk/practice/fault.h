// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace spherewalk::practice {

/// The troubles that the practice camera can make. In brackets: the name in POST /practice/faults, and the
/// member of Fault that says how much.
enum class FaultKind {
    // Troubles of one request and its answer.
    NeverAnswer,         ///< [never-answer] It reads the request, does nothing and keeps the connection open.
    DropAfterHeader,     ///< [drop-after-header] It closes the connection before it reads the body. For paths
                         ///< only.
    DropBeforeExecuting, ///< [drop-before-executing] It reads the request, does nothing and closes the
                         ///< connection.
    ExecuteThenDrop,     ///< [execute-then-drop] It obeys and closes the connection without an answer.
    ServiceUnavailable,  ///< [service-unavailable] It answers 503.
    Refuse,              ///< [refuse, code] It does nothing and answers with this error code.
    EmptyBody,           ///< [empty-body] It obeys and answers 200 without a body.
    WebPage,             ///< [web-page] It does nothing and answers with HTML, as a router does.
    MalformedJson,       ///< [malformed-json] It obeys and answers text that is no JSON.
    TruncatedJson, ///< [truncated-json, byte] It obeys and sends so many bytes as if they were the whole
                   ///< answer.
    ShortLength,   ///< [short-length] It obeys and states half the length of its answer.
    LongLength,    ///< [long-length] It obeys, states twice the length and closes the connection.
    Chunked,       ///< [chunked] It obeys and answers in chunks of 7 bytes.

    // Troubles of the next picture or the last one; on "camera.takePicture" or "/osc/commands/status".
    ForgetIds,        ///< [forget-ids] It forgets the ids of all commands so far.
    StuckInProgress,  ///< [stuck-in-progress] It says "in progress" of all running commands for ever.
    DoneWithoutUrl,   ///< [done-without-url] It names no file when the command is done.
    UrlOfOtherHost,   ///< [url-of-other-host] It names the file at a host that does not exist.
    EmptyPhoto,       ///< [empty-photo] It stores a file without bytes.
    SmallPhoto,       ///< [small-photo] It stores a picture of 640 x 360 pixels.
    NoMakerNote,      ///< [no-maker-note] It stores the picture without Ricoh's data.
    HostileMakerNote, ///< [hostile-maker-note] It stores the picture with offsets that lead out of the file.

    // Troubles of the download of a file; on "/files".
    MissingFile,   ///< [missing-file] It answers 404.
    CutDownload,   ///< [cut-download, byte] It closes the connection at this byte.
    StallDownload, ///< [stall-download, byte] It sends nothing after this byte and keeps the connection open.
    CorruptDownload, ///< [corrupt-download, byte] It replaces 64 bytes by 0xff, from this byte on.

    // Troubles of the preview. Each of its pictures counts as a call of "camera.getLivePreview".
    PreviewWithoutBoundary, ///< [preview-without-boundary] It sends a picture without its boundary.
    PreviewWrongLength,     ///< [preview-wrong-length, byte] It states this length of a picture.
    PreviewStall,           ///< [preview-stall] It sends no more pictures and keeps the connection open.

    // Troubles of the camera itself, just before it obeys a request. On "exposing" they come while it takes a
    // picture, on "written" after it stored the picture and before it announces it.
    RefuseConnections, ///< [refuse-connections, amount: seconds] It closes its port.
    Sleep,             ///< [sleep, amount: seconds] It closes its port and forgets its settings.
    Reboot,            ///< [reboot, amount: seconds] It closes its port and forgets everything but the files.
    StorageFull,       ///< [storage-full] It has no room for another picture.
    Battery,       ///< [battery, amount: lost fraction] It loses charge. At 0 it reboots for 3 s and is full.
    Hot,           ///< [hot] It is too hot to take pictures.
    ResetSettings, ///< [reset-settings] It goes back to its own settings.
    ExtraPhoto,    ///< [extra-photo] It takes a picture, as if somebody pressed its button.
    ClockUnset,    ///< [clock-unset] It forgets the time.
    OtherSerial,   ///< [other-serial] Another camera answers at the same address.
    LevelOne,      ///< [level-one] It falls back to API level 1 if its model has that.
    Plugin,        ///< [plugin] It starts a plug-in, which takes no pictures.
    RestartCounter, ///< [restart-counter] It deletes its files and gives their names again.
    UnknownValues,  ///< [unknown-values] It says things that no specification has.
    Slow,           ///< [slow, amount: factor] Each answer takes so much longer.
    StaleNonce,     ///< [stale-nonce] It rejects every nonce that it gave out.
    NoMoreTrouble,  ///< [no-more-trouble] It recovers: full battery, cool, no plug-in, quick, itself.
};

/// The name of the kind in the list above; "unknown" for any other value.
std::string_view name(FaultKind kind);

/// One trouble that the camera shall make.
struct Fault {
    FaultKind kind = FaultKind::DropBeforeExecuting;
    /// Calls that begin so can meet the fault: a command ("camera.takePicture") or a path ("/files"). Empty:
    /// all.
    std::string on;
    int skip = 0;           ///< So many calls pass before the first one meets the fault.
    int count = 1;          ///< So many calls meet the fault.
    std::uint64_t byte = 0; ///< Place in a file or an answer, or a length.
    double amount = 0;      ///< Seconds of the camera's time, a fraction, or a factor.
    std::string code = {};  ///< An error code of the API, such as "deviceBusy".

    /// Errors: InvalidInput for a negative skip, a count below 1, an amount outside [0, 1000], or an unknown
    /// code.
    void validate() const;
};

} // namespace spherewalk::practice
