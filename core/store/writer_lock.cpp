// SPDX-License-Identifier: GPL-3.0-or-later
#include "writer_lock.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace spherewalk::store {

namespace {

std::string holder(int descriptor) {
    std::array<char, 32> digits{};
    const ssize_t count = ::pread(descriptor, digits.data(), digits.size(), 0);
    const std::string_view written(digits.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    const auto process = parseNumber(written.substr(0, written.find('\n')));
    return process ? text(" (process ", static_cast<long long>(*process), ")") : "";
}

} // namespace

WriterLock::WriterLock(const std::filesystem::path& surveyFolder)
    : m_descriptor(::open((surveyFolder / "writer.lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666)) {
    if (m_descriptor < 0) {
        throw Error(ErrorKind::Io, text("Could not open the survey ", surveyFolder.string(),
                                        " for writing: ", std::strerror(errno),
                                        "; check the permissions, or open it for reading."));
    }
    if (::flock(m_descriptor, LOCK_EX | LOCK_NB) != 0) {
        const int reason = errno;
        const std::string process = holder(m_descriptor);
        ::close(m_descriptor);
        if (reason != EWOULDBLOCK) {
            throw Error(ErrorKind::Io, text("Could not lock the survey ", surveyFolder.string(),
                                            " for writing: ", std::strerror(reason), "."));
        }
        throw Error(ErrorKind::Busy,
                    text("The survey ", surveyFolder.string(), " is being written by another program",
                         process, "; close it there, or open it here for reading."));
    }
    // The process number only serves the sentence above: on a full disk the lock holds without it.
    const std::string process = text(static_cast<long long>(::getpid()), "\n");
    if (::ftruncate(m_descriptor, 0) == 0) {
        [[maybe_unused]] const ssize_t written = ::pwrite(m_descriptor, process.data(), process.size(), 0);
    }
}

WriterLock::~WriterLock() {
    ::close(m_descriptor);
}

} // namespace spherewalk::store
