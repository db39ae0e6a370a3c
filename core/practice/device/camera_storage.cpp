// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_commands.h"

#include "osc_parameters.h"

#include <algorithm>
#include <array>

namespace spherewalk::practice {

namespace {

constexpr std::size_t kMaxDeleted = 128;
constexpr std::int64_t kMany = 1'000'000'000;

Json entryOf(const CameraStorage& storage, const StoredFile& file, bool detail, const std::string& baseUrl) {
    Json entry;
    entry["name"] = file.name;
    entry["fileUrl"] = baseUrl + storage.urlPath(file.name);
    entry["size"] = file.sizeBytes;
    if (!detail) {
        entry["dateTime"] = exifTime(file.time);
        return entry;
    }
    entry["dateTimeZone"] = exifTime(file.time) + zoneText(file.time.zone);
    entry["width"] = file.width;
    entry["height"] = file.height;
    entry["isProcessed"] = true;
    entry["previewUrl"] = "";
    entry["_projectionType"] = "Equirectangular";
    return entry;
}

void requireKnown(const Json& parameters) {
    constexpr std::array<std::string_view, 7> kKnown = {
        "fileType", "entryCount", "maxThumbSize", "startPosition", "_startFileUrl", "_detail", "_sort"};
    for (const auto& parameter : parameters.items()) {
        if (std::find(kKnown.begin(), kKnown.end(), parameter.key()) == kKnown.end()) {
            throw OscError(OscCode::InvalidParameterName);
        }
    }
}

/// Where the asked part of the list begins.
std::size_t firstOf(const CameraStorage& storage, const std::vector<StoredFile>& files,
                    const Json& parameters) {
    std::size_t begin = 0;
    if (parameters.contains("startPosition")) {
        begin = static_cast<std::size_t>(wholeNumber(parameters["startPosition"], 0, kMany));
    } else if (parameters.contains("_startFileUrl")) {
        const Json& url = parameters["_startFileUrl"];
        const auto start = url.is_string() ? storage.find(url.get<std::string>()) : std::nullopt;
        if (!start) {
            throw OscError(OscCode::InvalidParameterValue);
        }
        while (begin < files.size() && files[begin].name != start->name) {
            ++begin;
        }
    }
    return begin;
}

} // namespace

Json listedFiles(const CameraStorage& storage, const Json& parameters, const std::string& baseUrl) {
    requireKnown(parameters);
    const std::string type = word(required(parameters, "fileType"), {"all", "image", "video"});
    const std::int64_t count = wholeNumber(required(parameters, "entryCount"), 0, kMany);
    const std::int64_t thumb = wholeNumber(required(parameters, "maxThumbSize"), 0, 640);
    if (thumb != 0 && thumb != 640) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    const bool detail = flag(parameters, "_detail", true);
    const bool newestFirst =
        !parameters.contains("_sort") || word(parameters["_sort"], {"newest", "oldest"}) == "newest";

    std::vector<StoredFile> files;
    if (type != "video") {
        files = storage.files();
    }
    if (newestFirst) {
        std::reverse(files.begin(), files.end());
    }
    const std::size_t begin = firstOf(storage, files, parameters);
    Json entries = Json::array();
    for (std::size_t i = begin; i < files.size() && static_cast<std::int64_t>(entries.size()) < count; ++i) {
        entries.push_back(entryOf(storage, files[i], detail, baseUrl));
    }
    return {{"entries", entries}, {"totalEntries", files.size()}};
}

Json listedImages(const CameraStorage& storage, const Json& parameters) {
    const std::int64_t count = wholeNumber(required(parameters, "entryCount"), 1, kMany);
    std::size_t begin = 0;
    if (parameters.contains("continuationToken")) {
        const Json& token = parameters["continuationToken"];
        const std::string digits = token.is_string() ? token.get<std::string>() : std::string();
        if (digits.empty() || digits.size() > 9 ||
            digits.find_first_not_of("0123456789") != std::string::npos) {
            throw OscError(OscCode::InvalidParameterValue);
        }
        begin = std::stoul(digits);
    }
    const std::vector<StoredFile>& files = storage.files();
    Json entries = Json::array();
    std::size_t i = begin;
    for (; i < files.size() && static_cast<std::int64_t>(entries.size()) < count; ++i) {
        const StoredFile& file = files[files.size() - 1 - i];
        entries.push_back({{"name", file.name},
                           {"uri", CameraStorage::uri(file.name)},
                           {"size", file.sizeBytes},
                           {"dateTimeZone", exifTime(file.time) + zoneText(file.time.zone)},
                           {"width", file.width},
                           {"height", file.height}});
    }
    Json results = {{"entries", entries}, {"totalEntries", files.size()}};
    if (i < files.size()) {
        results["continuationToken"] = std::to_string(i);
    }
    return results;
}

void deleteFiles(CameraStorage& storage, const Json& parameters) {
    const Json& urls = required(parameters, "fileUrls");
    if (!urls.is_array() || urls.empty()) {
        throw OscError(OscCode::InvalidParameterValue);
    }
    if (urls.size() > kMaxDeleted) {
        throw OscError(OscCode::TooManyParameters);
    }
    std::vector<std::string> names;
    const bool isAll = urls.size() == 1 && (urls[0] == "all" || urls[0] == "image");
    if (isAll) {
        for (const StoredFile& file : storage.files()) {
            names.push_back(file.name);
        }
    } else if (!(urls.size() == 1 && urls[0] == "video")) {
        for (const Json& url : urls) {
            const auto file = url.is_string() ? storage.find(url.get<std::string>()) : std::nullopt;
            if (!file) {
                throw OscError(OscCode::InvalidParameterValue); // all or nothing
            }
            names.push_back(file->name);
        }
    }
    for (const std::string& name : names) {
        storage.remove(name);
    }
}
} // namespace spherewalk::practice
