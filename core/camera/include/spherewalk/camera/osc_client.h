// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/clock.h"
#include "spherewalk/base/json.h"
#include "spherewalk/camera/http.h"
#include "spherewalk/camera/osc_messages.h"

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace spherewalk::camera {

/// How patient a client is.
struct OscOptions {
    HttpOptions http;
    std::chrono::milliseconds statusTimeout{5'000}; ///< Timeout of a question about a running command.
    int attempts = 3; ///< Number of tries for a repeatable request without a usable answer.
    std::chrono::milliseconds retryPause{1'000}; ///< Pause between the tries.
    std::chrono::milliseconds busyPause{
        1'000}; ///< Pause after the first "busy"; it doubles for each further one.
    std::chrono::milliseconds applyPause{
        1'000}; ///< Time from changing an option until a picture may be taken.

    /// Errors: InvalidInput, with the option and its range.
    void validate() const;
    /// The options with all pauses of the camera multiplied by the factor. Network timeouts stay.
    OscOptions scaled(double factor) const;
};

/// Which files to list, newest first.
struct FileQuery {
    std::string fileType = "image";
    int startPosition = 0;
    int entryCount = 20;
};

/// The commands of one Open Spherical Camera. Repeatable ones are sent again after a network failure, a
/// useless answer, or "busy"; takePicture is sent at most once. A camera that says that it speaks API levels
/// 1 and 2 is switched to 2 before the first command, and again when it has fallen back; one that speaks only
/// level 1 gets a session, and its files' URLs are paths made of the names that it uses
/// ("/100RICOH/R0010001.JPG"). Clients of another() share the session, which ends with the last of them. A
/// session of a program that was killed is taken over: its name is kept in a file of the user's. A camera
/// that has not been asked for its info speaks level 2. Errors of all: those of HttpClient; Unsupported for a
/// host that is no camera; Corrupt for answers that break the protocol; for a refused command the kind of its
/// code (see osc_error.h). Stop: within 200 ms. Threads: one at a time, so that one request is in flight.
class OscClient {
  public:
    /// Owner: the clock must outlive the client. Errors: InvalidInput.
    OscClient(Endpoint endpoint, OscOptions options, Clock& clock);

    const Endpoint& endpoint() const { return m_http.endpoint(); }

    /// Another client of the same camera, for another thread.
    std::unique_ptr<OscClient> another() const;

    CameraInfo info(const std::stop_token& stop);
    CameraState state(const std::stop_token& stop);
    /// The options as an object. Nothing if the camera does not know one of the names, because it then
    /// refuses all.
    std::optional<Json> findOptions(const std::vector<std::string>& names, const std::stop_token& stop);
    /// The same. Errors: Unsupported for an unknown name.
    Json getOptions(const std::vector<std::string>& names, const std::stop_token& stop);
    void setOptions(const Json& options, const std::stop_token& stop);
    FileList listFiles(const FileQuery& query, const std::stop_token& stop);
    /// The entry of this file, wherever it stands in the list; nothing if the camera does not have it.
    std::optional<FileEntry> findFile(std::string_view fileUrl, const std::stop_token& stop);

    /// Waits until the options that were changed last are in force.
    void waitUntilApplied(const std::stop_token& stop);
    /// Triggers once. A refusal is returned, not thrown. After any error it is unknown whether the camera has
    /// taken a picture.
    CommandReply takePicture(const std::stop_token& stop);
    /// True if the camera had left its API level or session, which explains a refusal, and has them again. It
    /// may have lost its settings with them.
    bool renewLevel(const std::stop_token& stop);
    /// How far a command is. A refusal (a forgotten id) is returned, not thrown.
    CommandReply status(const std::string& id, const std::stop_token& stop);

    /// One attempt to make the camera send its live preview: the bytes of its endless answer, until the
    /// camera ends it, as it does when it takes a picture; see HttpClient::stream. Errors: also the refusal.
    void streamPreview(const HttpClient::Sink& sink, const HttpClient::Tick& tick,
                       const std::stop_token& stop);

    /// To be told when the camera was busy with something else than this client's commands, such as a preview
    /// on another connection: the next picture waits as after a changed option.
    void noteDisturbed() { m_optionsSetAt = m_clock.now(); }

    /// One attempt; see HttpClient::download. Errors: also NotFound.
    HttpResponse download(std::string_view fileUrl, std::uint64_t maxBytes, const HttpClient::Sink& sink,
                          const std::stop_token& stop);

  private:
    struct Level;
    using Send = std::function<HttpResponse()>;

    template <class Understand>
    auto repeatable(const Send& send, const Understand& understand, const std::stop_token& stop);
    CommandReply ask(const std::string& command, const Json& parameters, const std::stop_token& stop);
    CommandReply execute(const std::string& command, const Json& parameters, std::string_view tried,
                         const std::stop_token& stop);
    void pause(Clock::Duration duration, const std::stop_token& stop);
    CommandReply askOnce(const std::string& command, const Json& parameters, const std::stop_token& stop);
    void enterLevel(const std::stop_token& stop);
    void switchToLevelTwo(const std::stop_token& stop);
    void startSession(const std::stop_token& stop);
    bool takeOverSession(bool mayBeOurs, const std::stop_token& stop);
    bool renewLevelAfter(const Json& session, const std::stop_token& stop);
    Json session() const;
    Json request(const std::string& command, Json parameters) const;
    FileList listImages(const FileQuery& query, const std::stop_token& stop);
    bool isLevelOneOnly() const;
    bool hasBothLevels() const;
    void setLevels(const std::vector<int>& levels);
    void noteVersion(std::optional<int> version);

    HttpClient m_http;
    OscOptions m_options;
    Clock& m_clock;
    std::optional<Clock::TimePoint> m_optionsSetAt;
    std::shared_ptr<Level> m_level; ///< Of all clients of this camera.
};

} // namespace spherewalk::camera
