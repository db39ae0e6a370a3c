// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program.h"

#include "spherewalk/base/json.h"

namespace spherewalk::test {

struct CliResult {
    int status = 0;
    std::string output;
    std::string errors;

    Json json() const { return parseJson(output, "the program's output"); }
};

/// Runs spherewalk-cli to its end.
inline CliResult runCli(std::vector<std::string> arguments, const Program::Options& options = {}) {
    arguments.insert(arguments.begin(), SPHEREWALK_CLI);
    Program program(arguments, options);
    const int status = program.wait();
    return {status, program.output(), program.errors()};
}

} // namespace spherewalk::test
