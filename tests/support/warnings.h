// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"

#include <string>
#include <string_view>
#include <vector>

namespace spherewalk::test {

/// Keeps what it is warned of.
class Warnings : public ProgressSink {
  public:
    void progress(double /*fraction*/, std::string_view /*activity*/) override {}

    void warning(std::string_view sentence) override { sentences.emplace_back(sentence); }

    std::vector<std::string> sentences;
};

} // namespace spherewalk::test
