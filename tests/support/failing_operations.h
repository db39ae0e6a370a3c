// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "file_fault.h" // of core/base, whose folder the test has on its include path

#include <atomic>

namespace spherewalk::test {

/// Lets one file operation fail as long as the object lives: the n-th one from 1 on.
class FailingOperations : public FileFault {
  public:
    /// code: what errno then says, for example ENOSPC.
    FailingOperations(int n, int code) : m_n(n), m_code(code), m_before(replaceFileFault(this)) {}

    ~FailingOperations() override { replaceFileFault(m_before); }

    FailingOperations(const FailingOperations&) = delete;
    FailingOperations& operator=(const FailingOperations&) = delete;

    /// True when the n-th operation was asked for, and so has failed.
    bool hasFailed() const { return m_asked >= m_n; }

    int errorOf(FileOperation /*operation*/, const std::filesystem::path& /*path*/) override {
        return ++m_asked == m_n ? m_code : 0;
    }

  private:
    int m_n;
    int m_code;
    std::atomic<int> m_asked{0};
    FileFault* m_before;
};

} // namespace spherewalk::test
