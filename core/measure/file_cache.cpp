// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_cache.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace spherewalk::measure {

namespace {

class Descriptor {
  public:
    explicit Descriptor(const std::filesystem::path& file)
        : m_number(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (m_number < 0) {
            throw Error(errno == ENOENT ? ErrorKind::NotFound : ErrorKind::Io,
                        text("Could not open ", file.string(), ": ", std::strerror(errno), "."));
        }
    }

    ~Descriptor() { ::close(m_number); }

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return m_number; }

  private:
    int m_number;
};

/// Whether any page of the file is in memory; true if the system does not say.
bool isCached(const Descriptor& file) {
    struct stat status {};

    if (::fstat(file.number(), &status) != 0 || status.st_size == 0) {
        return true;
    }
    const auto size = static_cast<std::size_t>(status.st_size);
    void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, file.number(), 0);
    if (mapped == MAP_FAILED) {
        return true;
    }
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    std::vector<unsigned char> pages((size + page - 1) / page);
    const bool isTold = ::mincore(mapped, size, pages.data()) == 0;
    ::munmap(mapped, size);
    return !isTold || std::any_of(pages.begin(), pages.end(), [](unsigned char p) { return (p & 1) != 0; });
}

} // namespace

bool dropFromFileCache(const std::filesystem::path& file) {
    const Descriptor descriptor(file);
    ::fdatasync(descriptor.number()); // what is not yet on the disk cannot be forgotten
    ::posix_fadvise(descriptor.number(), 0, 0, POSIX_FADV_DONTNEED);
    return !isCached(descriptor);
}

} // namespace spherewalk::measure
