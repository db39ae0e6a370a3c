// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"
#include "options/terminal.h"
#include "program/program.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"

#include <cstdio>
#include <optional>

namespace spherewalk::cli {

namespace {

void declareCommands(Commands& commands) {
    addNew(commands);
    addPlan(commands);
    addCapture(commands);
    addImport(commands);
    addAlign(commands);
    addRetag(commands);
    addReview(commands);
    addPrivacy(commands);
    addStatus(commands);
    addShots(commands);
    addCheck(commands);
    addExport(commands);
    addView(commands);
    addWalk(commands);
    addProbe(commands);
    addMeasure(commands);
    addGridStudy(commands);
    addCompare(commands);
    addBench(commands);
    addCamera(commands);
    addPracticeCamera(commands);
    addPracticePictures(commands);
    addDemo(commands);
}

int runChosen(const Commands& commands, const std::stop_token& stop) {
    return program::guarded(
        [&] {
            TerminalProgress progress;
            Context context{progress, stop, commands.json()};
            const Result result = commands.chosen()(context);
            program::printLine(stdout, commands.json() ? result.json.dump() : result.text);
            return result.succeeded ? program::kDone : program::kFailed;
        },
        [&](const Error& error) {
            if (commands.json()) {
                const Json report = {
                    {"error", {{"kind", name(error.kind())}, {"sentence", error.sentence()}}}};
                program::printLine(stdout, report.dump());
            }
        });
}

int runProgram(int argc, char** argv) {
    program::CommandLine line("Turns a room, scanned with a spherical camera, into a camera simulator.",
                              "spherewalk-cli", "spherewalk-cli " SPHEREWALK_VERSION);
    Commands commands(line.program());
    declareCommands(commands);
    if (const std::optional<int> status = line.parse(argc, argv)) {
        return *status;
    }
    const program::StopOnSignal signals;
    return runChosen(commands, signals.token());
}

} // namespace

} // namespace spherewalk::cli

int main(int argc, char** argv) {
    return spherewalk::cli::runProgram(argc, argv);
}
