// SPDX-License-Identifier: GPL-3.0-or-later
// API level 1: its sessions, its lists, and the way from it to level 2.
#include "osc/session_note.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/osc_client.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <mutex>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr std::size_t kMostPages = 1000;
constexpr int kMostOnAPage = 200;

bool contains(const std::vector<int>& levels, int level) {
    return std::find(levels.begin(), levels.end(), level) != levels.end();
}

/// Some cameras spell it as a number.
bool isSessionId(const Json& results) {
    return wholeNumber(results, "sessionId") || !shortText(results, "sessionId").value_or("").empty();
}

/// Source: the commands of API level 1 that name a sessionId among their parameters.
bool needsSession(std::string_view command) {
    constexpr std::array<std::string_view, 7> kInSession = {
        "camera.takePicture",    "camera.getOptions",    "camera.setOptions",  "camera._getLivePreview",
        "camera._stopSelfTimer", "camera.updateSession", "camera.closeSession"};
    return std::find(kInSession.begin(), kInSession.end(), command) != kInSession.end();
}

} // namespace

/// What all clients of one camera know of its level. The last of them closes the session.
struct OscClient::Level {
    Level(Endpoint where, HttpOptions with)
        : endpoint(std::move(where)), http(std::move(with)), note(endpoint) {}

    ~Level() {
        if (session.is_null()) {
            return;
        }
        constexpr std::chrono::seconds kPatience(2);
        http.connectTimeout = std::min<std::chrono::milliseconds>(http.connectTimeout, kPatience);
        try {
            const Json command{{"name", "camera.closeSession"}, {"parameters", {{"sessionId", session}}}};
            HttpClient(endpoint, http).post("/osc/commands/execute", command.dump(), {}, kPatience);
            note.clear();
        } catch (const Error&) {
            return; // The camera is gone; it ends an unused session by itself, and the note is of use until
                    // then.
        }
    }

    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

    Endpoint endpoint;
    HttpOptions http;
    SessionNote note;
    mutable std::recursive_mutex mutex; ///< Guards all below; held while the level changes.
    std::vector<int> apiLevels{2};      ///< Levels that the camera's info names.
    bool isSwitched = false;            ///< Whether the camera was switched from level 1 to 2.
    Json session;                       ///< Session of level 1 as the camera spells it; null without one.
};

OscClient::OscClient(Endpoint endpoint, OscOptions options, Clock& clock)
    : m_http(std::move(endpoint), options.http),
      m_options(std::move(options)),
      m_clock(clock),
      m_level(std::make_shared<Level>(m_http.endpoint(), m_options.http)) {
    m_options.validate();
}

std::unique_ptr<OscClient> OscClient::another() const {
    auto other = std::make_unique<OscClient>(endpoint(), m_options, m_clock);
    other->m_level = m_level;
    return other;
}

void OscClient::setLevels(const std::vector<int>& levels) {
    const std::scoped_lock lock(m_level->mutex);
    m_level->apiLevels = levels;
}

void OscClient::noteVersion(std::optional<int> version) {
    const std::scoped_lock lock(m_level->mutex);
    if (hasBothLevels()) {
        m_level->isSwitched = version.value_or(1) >= 2;
    }
}

bool OscClient::isLevelOneOnly() const {
    const std::scoped_lock lock(m_level->mutex);
    return !contains(m_level->apiLevels, 2);
}

bool OscClient::hasBothLevels() const {
    const std::scoped_lock lock(m_level->mutex);
    return contains(m_level->apiLevels, 1) && contains(m_level->apiLevels, 2);
}

Json OscClient::session() const {
    const std::scoped_lock lock(m_level->mutex);
    return m_level->session;
}

void OscClient::enterLevel(const std::stop_token& stop) {
    const std::scoped_lock lock(m_level->mutex);
    if (isLevelOneOnly()) {
        if (m_level->session.is_null()) {
            startSession(stop);
        }
    } else if (hasBothLevels() && !m_level->isSwitched && state(stop).apiVersion.value_or(1) < 2) {
        switchToLevelTwo(stop);
    }
}

void OscClient::startSession(const std::stop_token& stop) {
    m_level->session = nullptr;
    const CommandReply reply = askOnce("camera.startSession", Json::object(), stop);
    // Of a request that was sent twice, the first may have started the session that the second met.
    if (reply.error == OscErrorCode::ExclusiveUse && takeOverSession(reply.sent > 1, stop)) {
        return;
    }
    if (reply.error != OscErrorCode::None) {
        throw refusal("start a session", reply.error, reply.errorMessage);
    }
    if (!isSessionId(reply.results)) {
        throw Error(ErrorKind::Corrupt, "The camera started a session without a name; switch it off and on.");
    }
    m_level->session = reply.results["sessionId"];
    m_level->note.write(m_level->session);
}

/// Goes on with the session of a program of this user that could not close it. mayBeOurs: the session that
/// the camera's state names is ours too.
bool OscClient::takeOverSession(bool mayBeOurs, const std::stop_token& stop) {
    Json session = m_level->note.read();
    if (session.is_null() && mayBeOurs) {
        if (const std::string id = state(stop).sessionId; !id.empty()) {
            session = id;
        }
    }
    if (session.is_null()) {
        return false;
    }
    m_level->session = session;
    if (askOnce("camera.updateSession", Json::object(), stop).error != OscErrorCode::None) {
        m_level->session = nullptr; // of a session that is over, while another's is not
        return false;
    }
    m_level->note.write(session);
    return true;
}

void OscClient::switchToLevelTwo(const std::stop_token& stop) {
    startSession(stop);
    const CommandReply reply = askOnce("camera.setOptions", {{"options", {{"clientVersion", 2}}}}, stop);
    m_level->session = nullptr; // level 2 has none
    m_level->note.clear();
    if (reply.error != OscErrorCode::None) {
        throw refusal("speak API level 2", reply.error, reply.errorMessage);
    }
    m_optionsSetAt = m_clock.now();
    if (state(stop).apiVersion.value_or(2) < 2) {
        throw Error(ErrorKind::Unsupported,
                    "The camera stays at API level 1 although it offers level 2; switch it off and on.");
    }
    m_level->isSwitched = true;
}

bool OscClient::renewLevel(const std::stop_token& stop) {
    const std::scoped_lock lock(m_level->mutex);
    if (isLevelOneOnly()) {
        startSession(stop);
        return true;
    }
    if (!hasBothLevels() || state(stop).apiVersion.value_or(1) >= 2) {
        return false;
    }
    switchToLevelTwo(stop);
    return true;
}

/// before: the session of the command that was refused. Another client may have begun a new one since.
bool OscClient::renewLevelAfter(const Json& before, const std::stop_token& stop) {
    const std::scoped_lock lock(m_level->mutex);
    const bool isRenewed = isLevelOneOnly() && !m_level->session.is_null() && m_level->session != before;
    return isRenewed || renewLevel(stop);
}

/// The command as the level in force wants it.
Json OscClient::request(const std::string& command, Json parameters) const {
    if (const Json own = session(); !own.is_null() && needsSession(command)) {
        parameters["sessionId"] = own;
    }
    Json request{{"name", command}};
    if (!parameters.empty()) {
        request["parameters"] = std::move(parameters);
    }
    return request;
}

FileList OscClient::listImages(const FileQuery& query, const std::stop_token& stop) {
    // There is no start position, only a token from page to page.
    const auto wanted =
        static_cast<std::size_t>(query.startPosition) + static_cast<std::size_t>(query.entryCount);
    FileList all;
    std::string token;
    for (std::size_t page = 0; page < kMostPages; ++page) {
        const int count = std::min(kMostOnAPage, static_cast<int>(wanted - all.entries.size()));
        Json parameters{{"entryCount", count}, {"includeThumb", false}};
        if (!token.empty()) {
            parameters["continuationToken"] = token;
        }
        const CommandReply reply = askOnce("camera.listImages", parameters, stop); // which needs no session
        if (reply.error != OscErrorCode::None) {
            throw refusal("list its files", reply.error, reply.errorMessage);
        }
        FileList part = parseImageList(reply.results);
        all.totalEntries = part.totalEntries;
        std::move(part.entries.begin(), part.entries.end(), std::back_inserter(all.entries));
        token = shortText(reply.results, "continuationToken").value_or("");
        if (token.empty() || part.entries.empty() || all.entries.size() >= wanted) {
            break;
        }
    }
    const auto skipped = std::min(all.entries.size(), static_cast<std::size_t>(query.startPosition));
    all.entries.erase(all.entries.begin(), all.entries.begin() + static_cast<std::ptrdiff_t>(skipped));
    return all;
}

} // namespace spherewalk::camera
