// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/progress.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace spherewalk::test {

/// Keeps all that a job reports. A warning fails the test.
class KeptProgress : public ProgressSink {
  public:
    void progress(double fraction, std::string_view activity) override {
        fractions.push_back(fraction);
        lastActivity = activity;
        EXPECT_NE(activity, "");
    }

    void warning(std::string_view sentence) override { ADD_FAILURE() << sentence; }

    std::vector<double> fractions;
    std::string lastActivity;
};

} // namespace spherewalk::test
