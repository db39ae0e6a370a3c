// SPDX-License-Identifier: GPL-3.0-or-later
// API level 1: its sessions, its lists, and the way from it to level 2.
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/camera/osc_client.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace spherewalk::camera {

namespace {

constexpr std::size_t kMostPages = 1000;
constexpr int kMostOnAPage = 200;

bool contains(const std::vector<int>& levels, int level) {
    return std::find(levels.begin(), levels.end(), level) != levels.end();
}

} // namespace

bool OscClient::isLevelOneOnly() const {
    return !contains(m_apiLevels, 2);
}

bool OscClient::hasBothLevels() const {
    return contains(m_apiLevels, 1) && contains(m_apiLevels, 2);
}

void OscClient::enterLevel(const std::stop_token& stop) {
    if (isLevelOneOnly()) {
        if (m_session.is_null()) {
            startSession(stop);
        }
    } else if (hasBothLevels() && !m_isSwitched && state(stop).apiVersion.value_or(1) < 2) {
        switchToLevelTwo(stop);
    }
}

void OscClient::startSession(const std::stop_token& stop) {
    m_session = nullptr;
    const CommandReply reply = askOnce("camera.startSession", Json::object(), stop);
    if (reply.error != OscErrorCode::None) {
        throw refusal("start a session", reply.error, reply.errorMessage);
    }
    // Some cameras spell it as a number.
    if (!wholeNumber(reply.results, "sessionId") &&
        shortText(reply.results, "sessionId").value_or("").empty()) {
        throw Error(ErrorKind::Corrupt, "The camera started a session without a name; switch it off and on.");
    }
    m_session = reply.results["sessionId"];
}

void OscClient::switchToLevelTwo(const std::stop_token& stop) {
    startSession(stop);
    const CommandReply reply = askOnce("camera.setOptions", {{"options", {{"clientVersion", 2}}}}, stop);
    m_session = nullptr;
    if (reply.error != OscErrorCode::None) {
        throw refusal("speak API level 2", reply.error, reply.errorMessage);
    }
    m_optionsSetAt = m_clock.now();
    if (state(stop).apiVersion.value_or(2) < 2) {
        throw Error(ErrorKind::Unsupported,
                    "The camera stays at API level 1 although it offers level 2; switch it off and on.");
    }
    m_isSwitched = true;
}

bool OscClient::renewLevel(const std::stop_token& stop) {
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

/// The command as the level in force wants it.
Json OscClient::request(const std::string& command, Json parameters) const {
    if (!m_session.is_null()) {
        parameters["sessionId"] = m_session;
    }
    Json request{{"name", command}};
    if (!parameters.empty()) {
        request["parameters"] = std::move(parameters);
    }
    return request;
}

FileList OscClient::listImages(const FileQuery& query, const std::stop_token& stop) {
    // There is no start position, only a token from page to page.
    const auto wanted = static_cast<std::size_t>(query.startPosition + query.entryCount);
    FileList all;
    std::string token;
    for (std::size_t page = 0; page < kMostPages; ++page) {
        const int count = std::min(kMostOnAPage, static_cast<int>(wanted - all.entries.size()));
        Json parameters{{"entryCount", count}, {"includeThumb", false}};
        if (!token.empty()) {
            parameters["continuationToken"] = token;
        }
        const CommandReply reply = execute("camera.listImages", parameters, "list its files", stop);
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
