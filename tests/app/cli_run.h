// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"

#include <filesystem>
#include <string>

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

/// Of a robot's camera that takes little time to render. Returns the file's name.
inline std::string writeSmallCamera(const std::filesystem::path& file) {
    writeFile(file, bytesOf("image_width: 160\nimage_height: 120\n"
                            "camera_matrix: {data: [120, 0, 79.5, 0, 120, 59.5, 0, 0, 1]}\n"));
    return file;
}

} // namespace spherewalk::test
