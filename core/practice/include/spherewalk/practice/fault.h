// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace spherewalk::practice {

/// What the practice camera can be told to do wrong. In brackets: the name in POST /practice/faults, and the
/// member of Fault that says how much.
enum class FaultKind {
    // To one request, and its answer.
    NeverAnswer,         ///< [never-answer] reads it, does nothing, keeps the connection open
    DropAfterHeader,     ///< [drop-after-header] closes the connection before it reads the body; on a path
    DropBeforeExecuting, ///< [drop-before-executing] reads it, closes the connection, does nothing
    ExecuteThenDrop,     ///< [execute-then-drop] does as told, closes the connection without an answer
    ServiceUnavailable,  ///< [service-unavailable] answers 503
    Refuse,              ///< [refuse, code] does nothing, answers with this error code
    EmptyBody,           ///< [empty-body] does as told, answers 200 without a body
    WebPage,             ///< [web-page] does nothing, answers with HTML, as a router does
    MalformedJson,       ///< [malformed-json] does as told, answers what is no JSON
    TruncatedJson, ///< [truncated-json, byte] does as told, sends so much of the answer as if it were all
    ShortLength,   ///< [short-length] does as told, states half the length of its answer
    LongLength,    ///< [long-length] does as told, states twice the length, closes the connection
    Chunked,       ///< [chunked] does as told, answers in chunks of 7 bytes

    // To the picture that is taken next, or the last one; on "camera.takePicture" or "/osc/commands/status".
    ForgetIds,        ///< [forget-ids] no longer knows the ids given out so far
    StuckInProgress,  ///< [stuck-in-progress] says "in progress" of all running commands for ever
    DoneWithoutUrl,   ///< [done-without-url] names no file when the command is done
    UrlOfOtherHost,   ///< [url-of-other-host] names the file at a host that does not exist
    EmptyPhoto,       ///< [empty-photo] stores a file of no length
    SmallPhoto,       ///< [small-photo] stores a picture of 640 x 360 pixels
    NoMakerNote,      ///< [no-maker-note] stores it without Ricoh's data
    HostileMakerNote, ///< [hostile-maker-note] stores it with offsets that lead nowhere

    // To the download of a file; on "/files".
    MissingFile,     ///< [missing-file] answers 404
    CutDownload,     ///< [cut-download, byte] closes the connection there
    StallDownload,   ///< [stall-download, byte] sends nothing from there on, keeps the connection open
    CorruptDownload, ///< [corrupt-download, byte] replaces the 64 bytes from there on, by 0xff

    // To the preview; each of its pictures is a call of "camera.getLivePreview".
    PreviewWithoutBoundary, ///< [preview-without-boundary] sends a picture without its boundary
    PreviewWrongLength,     ///< [preview-wrong-length, byte] states that length of a picture
    PreviewStall,           ///< [preview-stall] sends no more, keeps the connection open

    // To the camera itself, just before it does what it is asked to; or on "exposing", when a picture is
    // being taken, or on "written", when it is stored and not yet announced.
    RefuseConnections, ///< [refuse-connections, amount: seconds] closes its port
    Sleep,             ///< [sleep, amount: seconds] the same, and forgets its settings; somebody wakes it
    Reboot,            ///< [reboot, amount: seconds] the same, and forgets everything but the files
    StorageFull,       ///< [storage-full] has no room for another picture
    Battery,        ///< [battery, amount: lost fraction] loses charge; switches off for 3 s at 0, and is full
    Hot,            ///< [hot] is too hot to take pictures
    ResetSettings,  ///< [reset-settings] goes back to its own settings
    ExtraPhoto,     ///< [extra-photo] takes a picture, as if somebody pressed its button
    ClockUnset,     ///< [clock-unset] forgets the time
    OtherSerial,    ///< [other-serial] is another camera at the same address
    LevelOne,       ///< [level-one] falls back to API level 1 if it has that
    Plugin,         ///< [plugin] starts a plug-in, which takes no pictures
    RestartCounter, ///< [restart-counter] deletes its files and gives their names again
    UnknownValues,  ///< [unknown-values] says things that are in no specification
    Slow,           ///< [slow, amount: factor] takes so much longer for each answer
    StaleNonce,     ///< [stale-nonce] takes no nonce any longer that it has given out
    NoMoreTrouble,  ///< [no-more-trouble] is as it was: full battery, cool, no plug-in, quick, itself
};

/// The kind's name, as in the list above; "unknown" for anything else.
std::string_view name(FaultKind kind);

/// One thing that is to go wrong, `count` times, after `skip` calls that it could have met.
struct Fault {
    FaultKind kind = FaultKind::DropBeforeExecuting;
    std::string
        on; ///< the beginning of a command ("camera.takePicture") or path ("/files"); empty: any request
    int skip = 0;
    int count = 1;
    std::uint64_t byte = 0; ///< of a file or an answer
    double amount = 0;      ///< seconds of the camera's time, a fraction, a factor
    std::string code = {};  ///< "deviceBusy"

    /// Errors: InvalidInput for a negative skip, a count below 1, an amount that is not between 0 and 1000,
    /// a code that the camera does not know.
    void validate() const;
};

} // namespace spherewalk::practice
