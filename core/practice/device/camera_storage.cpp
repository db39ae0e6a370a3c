// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/camera_storage.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/fixed_random.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <array>
#include <utility>

namespace spherewalk::practice {

namespace {

constexpr std::string_view kDcfFolder = "100RICOH";
constexpr int kFirstNumber = 10000;
constexpr std::uint64_t kMaxStoredBytes = 256ULL << 20;

std::string hexDigits(std::uint64_t seed, std::size_t count) {
    FixedRandom random(seed, 0x5704a6e);
    std::string digits;
    while (digits.size() < count) {
        digits += "0123456789abcdef"[random.next() % 16];
    }
    return digits;
}

bool isPhotoName(const std::string& name) {
    return name.size() == 12 && name.starts_with("R") && name.ends_with(".JPG");
}

/// Of no pixels for what is no picture.
jpeg::Info sizeOf(ByteView bytes, const std::string& name) {
    try {
        return jpeg::readInfo(bytes, name);
    } catch (const Error&) { // a camera stores a damaged photo all the same
        return {};
    }
}

} // namespace

CameraStorage::CameraStorage(std::filesystem::path folder, std::uint64_t seed)
    : m_folder(std::move(folder)), m_id(hexDigits(seed, 30)) {
    if (m_folder.empty()) {
        m_folder = m_temporary.emplace("practice-camera").path();
    }
    ensureFolder(m_folder / kDcfFolder);
    load();
    m_urlFolder = text("/files/", m_id, "/");
}

void CameraStorage::load() {
    const std::filesystem::path record = m_folder / "camera.json";
    if (std::filesystem::exists(record)) {
        const Json content = parseJson(readTextFile(record, 1 << 16), record.string());
        const JsonReader reader(content, record.string());
        m_id = reader.string("storage_id");
        m_nextShot = static_cast<int>(reader.integer("next_shot", 1, 1 << 30));
        m_namedFrom =
            reader.isAbsent("named_from") ? 0 : static_cast<int>(reader.integer("named_from", 0, m_nextShot));
        if (!std::all_of(m_id.begin(), m_id.end(), [](char c) { return c >= '0' && c <= 'z'; })) {
            reader.fail("the storage id is not made of digits and letters");
        }
    } else {
        save();
    }
    for (const auto& entry : std::filesystem::directory_iterator(m_folder / kDcfFolder)) {
        const std::string name = entry.path().filename().string();
        if (!isPhotoName(name)) {
            continue;
        }
        const Bytes bytes = readFile(entry.path(), kMaxStoredBytes);
        const jpeg::Info info = sizeOf(bytes, name);
        const auto written = std::filesystem::last_write_time(entry.path());
        const auto utc = std::chrono::time_point_cast<std::chrono::system_clock::duration>(
            std::chrono::file_clock::to_sys(written));
        m_files.push_back({name, bytes.size(), info.width, info.height, {utc, std::chrono::minutes(0)}});
    }
    std::sort(m_files.begin(), m_files.end(),
              [](const StoredFile& a, const StoredFile& b) { return a.name < b.name; });
}

void CameraStorage::save() const {
    const Json record = {{"storage_id", m_id}, {"next_shot", m_nextShot}, {"named_from", m_namedFrom}};
    writeFile(m_folder / "camera.json", bytesOf(record.dump() + "\n"));
}

int CameraStorage::takeShotNumber() {
    const int shot = m_nextShot++;
    save();
    return shot;
}

void CameraStorage::restartNames() {
    while (!m_files.empty()) {
        remove(std::string(m_files.back().name));
    }
    m_namedFrom = m_nextShot - 1;
    save();
}

std::string CameraStorage::fileName(int shot) const {
    std::string digits = std::to_string(kFirstNumber + shot - m_namedFrom);
    return "R" + std::string(digits.size() < 7 ? 7 - digits.size() : 0, '0') + digits + ".JPG";
}

std::string CameraStorage::urlPath(const std::string& name) const {
    return m_urlFolder + uri(name);
}

std::string CameraStorage::uri(const std::string& name) {
    return text(kDcfFolder, "/", name);
}

std::filesystem::path CameraStorage::path(const std::string& name) const {
    return m_folder / kDcfFolder / name;
}

void CameraStorage::add(const std::string& name, ByteView bytes, const ZonedTime& time) {
    const jpeg::Info info = sizeOf(bytes, name);
    writeFile(path(name), bytes, DurableFile::Overwrite::No);
    m_files.push_back({name, bytes.size(), info.width, info.height, time});
}

void CameraStorage::remove(const std::string& name) {
    std::error_code failure;
    std::filesystem::remove(path(name), failure);
    if (failure) {
        throw Error(ErrorKind::Io,
                    text("Could not delete ", path(name).string(), ": ", failure.message(), "."));
    }
    std::erase_if(m_files, [&](const StoredFile& file) { return file.name == name; });
}

std::uint64_t CameraStorage::usedBytes() const {
    std::uint64_t used = 0;
    for (const StoredFile& file : m_files) {
        used += file.sizeBytes;
    }
    return used;
}

std::optional<StoredFile> CameraStorage::find(std::string_view url) const {
    const std::size_t begin = url.find("/files/");
    if (begin == std::string_view::npos) {
        return std::nullopt;
    }
    const std::string_view path = url.substr(begin);
    for (const StoredFile& file : m_files) {
        if (urlPath(file.name) == path) {
            return file;
        }
    }
    return std::nullopt;
}

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
