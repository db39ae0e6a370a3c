// SPDX-License-Identifier: Apache-2.0
#include "spherewalk/base/temporary_folder.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <cerrno>
#include <cstring>
#include <stdlib.h> // mkdtemp
#include <string>
#include <system_error>

namespace spherewalk {

namespace fs = std::filesystem;

TemporaryFolder::TemporaryFolder(std::string_view name) {
    std::error_code failure;
    std::string pattern = (fs::temp_directory_path(failure) / text(name, "-XXXXXX")).string();
    if (failure || ::mkdtemp(pattern.data()) == nullptr) {
        throw Error(ErrorKind::Io, text("Could not make a temporary folder ", pattern, ": ",
                                        failure ? failure.message() : std::string(std::strerror(errno)),
                                        "; set TMPDIR to a folder that can be written."));
    }
    m_path = pattern;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored; // what is left of a temporary folder does no harm
    fs::remove_all(m_path, ignored);
}

} // namespace spherewalk
