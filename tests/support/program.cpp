// SPDX-License-Identifier: GPL-3.0-or-later
#include "program.h"

#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <linux/capability.h>
#include <poll.h>
#include <sstream>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace spherewalk::test {

namespace {

std::string temporaryFile() {
    std::string name = "/tmp/spherewalk-test-XXXXXX";
    const int descriptor = ::mkstemp(name.data());
    if (descriptor < 0) {
        throw std::runtime_error("mkstemp failed");
    }
    ::close(descriptor);
    return name;
}

std::string contents(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// In the child, before the program: standard streams and limits.
void becomeProgram(const std::vector<std::string>& command, const Program::Options& options,
                   const std::string& inputFile, const std::string& outputFile,
                   const std::string& errorFile) {
    ::dup2(::open(inputFile.c_str(), O_RDONLY), STDIN_FILENO);
    ::dup2(::open(outputFile.c_str(), O_WRONLY | O_TRUNC), STDOUT_FILENO);
    ::dup2(::open(errorFile.c_str(), O_WRONLY | O_TRUNC), STDERR_FILENO);
    ::signal(SIGINT, SIG_DFL); // a shell lets what it runs in the background ignore it
    if (options.fileSizeLimit) {
        const auto bytes = static_cast<rlim_t>(*options.fileSizeLimit);
        const rlimit limit{bytes, bytes};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ::signal(SIGXFSZ, SIG_IGN);
    }
    for (const int capability : {CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH}) {
        if (options.obeysPermissions) {
            ::prctl(PR_CAPBSET_DROP, capability); // refused to others, who have to obey anyway
        }
    }
    std::vector<char*> arguments;
    for (const std::string& word : command) {
        arguments.push_back(const_cast<char*>(word.c_str()));
    }
    arguments.push_back(nullptr);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
}

} // namespace

Program::Program(const std::vector<std::string>& command, const Options& options)
    : m_inputFile(temporaryFile()), m_outputFile(temporaryFile()), m_errorFile(temporaryFile()) {
    std::ofstream(m_inputFile) << options.input;
    m_pid = ::fork();
    if (m_pid == 0) {
        becomeProgram(command, options, options.inputFile.empty() ? m_inputFile : options.inputFile,
                      m_outputFile, m_errorFile);
    }
    m_pidFd = static_cast<int>(::syscall(SYS_pidfd_open, m_pid, 0));
    if (m_pid < 0 || m_pidFd < 0) {
        throw std::runtime_error("could not start " + command.front());
    }
}

Program::~Program() {
    if (!m_status) {
        signal(SIGKILL);
        wait();
    }
    ::close(m_pidFd);
    for (const std::string& file : {m_inputFile, m_outputFile, m_errorFile}) {
        ::unlink(file.c_str());
    }
}

void Program::signal(int number) const {
    ::kill(m_pid, number);
}

bool Program::endsWithin(std::chrono::milliseconds time) const {
    pollfd ended{m_pidFd, POLLIN, 0};
    return m_status || ::poll(&ended, 1, static_cast<int>(time.count())) > 0;
}

int Program::wait() {
    if (!m_status) {
        int status = 0;
        ::waitpid(m_pid, &status, 0);
        m_status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    return *m_status;
}

std::string Program::waitForError(const std::string& text) const {
    for (bool ended = false; !ended;) {
        ended = endsWithin(std::chrono::milliseconds(20));
        const std::string so = errors();
        if (so.find(text) != std::string::npos) {
            return so;
        }
    }
    return {};
}

std::string Program::output() const {
    return contents(m_outputFile);
}

std::string Program::errors() const {
    return contents(m_errorFile);
}

} // namespace spherewalk::test
