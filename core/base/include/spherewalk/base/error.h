// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace spherewalk {

/// The kinds of failure that a program can react to in different ways.
enum class ErrorKind {
    InvalidInput, ///< An argument or option of the caller cannot be used.
    NotFound,     ///< A file, station or resource is missing.
    Exists,       ///< Something exists that must not be overwritten.
    Io,           ///< The operating system refused to read or write.
    Network,      ///< A host could not be reached or broke the connection.
    Timeout,      ///< An answer did not come in time.
    Stopped,      ///< The caller asked to stop.
    Corrupt,      ///< Data from outside contradicts itself or its format.
    Unsupported,  ///< This version or this camera cannot do it.
    Busy,         ///< Another program holds it, or the device is occupied.
    Full,         ///< There is no space left.
    Internal,     ///< Spherewalk has a defect.
};

/// The kind's name in logs and JSON outputs, for example "invalid_input".
std::string_view name(ErrorKind kind);

/// The one exception that crosses modules. The kind is for the program, the sentence for the person. The
/// sentence says what was tried, on which thing, and what to do. The context holds details for developers.
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
