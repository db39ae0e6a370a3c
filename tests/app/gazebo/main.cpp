// SPDX-License-Identifier: GPL-3.0-or-later
#include "messages.h"

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    spherewalk::gazebo::endProgram(RUN_ALL_TESTS());
}
