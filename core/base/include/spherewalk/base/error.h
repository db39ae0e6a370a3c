// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace spherewalk {

/// What went wrong, as far as a program needs to know it to branch.
enum class ErrorKind {
    InvalidInput, ///< what the caller gave cannot be used
    NotFound,     ///< a file, station or resource that should be there is not
    Exists,       ///< something that must not be overwritten is already there
    Io,           ///< the operating system refused to read or write
    Network,      ///< a host could not be reached or broke the connection
    Timeout,      ///< no answer in time
    Stopped,      ///< the caller asked to stop
    Corrupt,      ///< data from outside contradicts itself or its format
    Unsupported,  ///< well-formed, but beyond what this version or this camera can do
    Busy,         ///< held by another program, or the device is occupied
    Full,         ///< no space left
    Internal,     ///< a defect of Spherewalk
};

/// The kind's name as logs and JSON output spell it, for example "invalid_input".
std::string_view name(ErrorKind kind);

/// The one exception that crosses modules: a kind for the program and a sentence for the person. The sentence
/// says what was tried, on what, and what to do; the context holds what only a developer wants to read.
class Error : public std::exception {
  public:
    Error(ErrorKind kind, std::string sentence, std::string context = {});

    ErrorKind kind() const noexcept { return m_kind; }

    const std::string& sentence() const noexcept { return m_sentence; }

    const std::string& context() const noexcept { return m_context; }

    const char* what() const noexcept override { return m_sentence.c_str(); }

  private:
    ErrorKind m_kind;
    std::string m_sentence;
    std::string m_context;
};

} // namespace spherewalk
