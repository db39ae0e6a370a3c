// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace spherewalk::test {

/// A program that runs beside the test; killed at the end of the scope if it still runs.
class Program {
  public:
    struct Options {
        std::string input = {};                 ///< standard input
        std::optional<long> fileSizeLimit = {}; ///< RLIMIT_FSIZE, bytes
        bool obeysPermissions = false;          ///< of files and folders, also as the superuser
        std::string inputFile = {};             ///< what standard input is in its place: a terminal, a pipe
    };

    Program(const std::vector<std::string>& command, const Options& options);

    explicit Program(const std::vector<std::string>& command) : Program(command, Options{}) {}

    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void signal(int number) const;
    /// True if it ended within the time.
    bool endsWithin(std::chrono::milliseconds time) const;
    /// Waits for the end; the exit status, or 128 + the signal that ended it.
    int wait();
    /// Waits until the text appears on standard error and returns all of it so far; "" if the program ends
    /// before.
    std::string waitForError(const std::string& text) const;

    /// What it has written so far.
    std::string output() const;
    std::string errors() const;

  private:
    std::string m_inputFile;
    std::string m_outputFile;
    std::string m_errorFile;
    pid_t m_pid = -1;
    int m_pidFd = -1;
    std::optional<int> m_status;
};

} // namespace spherewalk::test
