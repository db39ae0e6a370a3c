// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/delay_memory.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/camera/osc_messages.h"

#include <cctype>
#include <string>
#include <system_error>

namespace spherewalk::camera {

DelayMemory::DelayMemory(const std::filesystem::path& folder, std::string_view serialNumber) {
    std::string name("camera-");
    for (const char c : serialNumber.substr(0, 64)) {
        name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    m_file = folder / (name + ".json");
}

Json DelayMemory::read() const {
    constexpr std::uint64_t kMostBytes = 4096;
    constexpr std::int64_t kLongestS = 604'800;
    std::error_code failure;
    if (!std::filesystem::exists(m_file, failure)) {
        return nullptr;
    }
    try {
        const Json kept = parseJson(readTextFile(m_file, kMostBytes), m_file.string());
        Json delays = Json::object();
        for (const char* name : kDelayNames) {
            if (const auto seconds = wholeNumber(kept, name);
                seconds && *seconds >= 0 && *seconds <= kLongestS) {
                delays[name] = *seconds;
            }
        }
        return delays.empty() ? Json() : delays;
    } catch (const Error&) { // damaged: what the camera is set to now is the next best
        return nullptr;
    }
}

void DelayMemory::write(const Json& delays) const {
    try {
        writeFile(m_file, bytesOf(delays.dump()), DurableFile::Overwrite::Yes);
    } catch (const Error& error) {
        // A folder of this computer that is not there must not look like something that the camera lacks.
        throw Error(error.kind() == ErrorKind::NotFound ? ErrorKind::Io : error.kind(), error.sentence(),
                    error.context());
    }
}

void DelayMemory::forget() const {
    std::error_code ignored; // what is put back twice does no harm
    std::filesystem::remove(m_file, ignored);
}

} // namespace spherewalk::camera
