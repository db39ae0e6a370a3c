// SPDX-License-Identifier: GPL-3.0-or-later
#include "osc/session_note.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"

#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <system_error>
#include <unistd.h>

namespace spherewalk::camera {

namespace {

constexpr std::uint64_t kMostBytes = 4096;

/// A folder of the user's that a restart of the machine empties, as it ends sessions.
std::filesystem::path noteFolder() {
    if (const char* folder = std::getenv("XDG_RUNTIME_DIR"); folder != nullptr && *folder == '/') {
        return folder;
    }
    std::error_code failure;
    return std::filesystem::temp_directory_path(failure) / text("spherewalk-", ::getuid());
}

/// Whether another process with this number runs.
bool isOtherAndRuns(std::int64_t process) {
    return process != ::getpid() && process > 0 &&
           (::kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM);
}

std::string fileName(const Endpoint& endpoint) {
    std::string name = "spherewalk-session-" + endpoint.name();
    for (char& c : name) {
        c = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '-' ? c : '_';
    }
    return name;
}

} // namespace

SessionNote::SessionNote(const Endpoint& endpoint) : m_file(noteFolder() / fileName(endpoint)) {
}

void SessionNote::write(const Json& session) const {
    try {
        std::error_code failure;
        if (std::filesystem::create_directory(m_file.parent_path(), failure)) {
            std::filesystem::permissions(m_file.parent_path(), std::filesystem::perms::owner_all);
        }
        writeFile(m_file, bytesOf(Json{{"session", session}, {"process", ::getpid()}}.dump()));
    } catch (const Error&) {
        clear(); // of an older session
    } catch (const std::filesystem::filesystem_error&) {
        clear();
    }
}

void SessionNote::clear() const {
    std::error_code failure;
    std::filesystem::remove(m_file, failure);
}

Json SessionNote::read() const {
    try {
        const Json note = parseJson(readTextFile(m_file, kMostBytes), "the note of a session");
        if (!note.is_object() || !note.contains("session") || isOtherAndRuns(note.value("process", 0))) {
            return {};
        }
        const Json& session = note["session"];
        return session.is_string() || session.is_number_integer() ? session : Json();
    } catch (const Error&) {
        return {};
    } catch (const Json::exception&) { // a process that is no number
        return {};
    }
}

} // namespace spherewalk::camera
