// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace spherewalk {

/// The file operations that a test can let fail.
enum class FileOperation { Open, Read, Write, Sync, Rename, MakeFolder };

/// Decides, in tests only, which file operations fail. No program includes this header: the programs have no
/// option, environment variable, or file that leads here. Threads: operations ask from any thread.
class FileFault {
  public:
    virtual ~FileFault() = default;

    /// 0 if the operation shall be done; otherwise it is not done, and fails with this value of errno.
    virtual int errorOf(FileOperation operation, const std::filesystem::path& path) = 0;
};

/// Lets the fault decide from now on, or nobody for nullptr. Returns what decided before.
/// Owner: the caller keeps the fault alive until it is replaced.
FileFault* replaceFileFault(FileFault* fault);

/// What the installed fault decides; 0 if there is none, which costs one load from memory.
int faultOf(FileOperation operation, const std::filesystem::path& path);

} // namespace spherewalk
