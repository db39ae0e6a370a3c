// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"
#include "program/program.h"
#include "program/stop_on_signal.h"
#include "terminal.h"

#include "spherewalk/base/error.h"

#include <cstdio>

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
    addStatus(commands);
    addCheck(commands);
    addExport(commands);
    addView(commands);
    addWalk(commands);
    addMeasure(commands);
    addGridStudy(commands);
    addCompare(commands);
    addBench(commands);
    addCamera(commands);
    addPracticeCamera(commands);
    addDemo(commands);
}

int run(const Commands& commands, const std::stop_token& stop) {
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
    CLI::App app("Turns a room, scanned with a spherical camera, into a camera simulator.", "spherewalk-cli");
    app.set_version_flag("--version", "spherewalk-cli " SPHEREWALK_VERSION);
    app.require_subcommand(1);
    Commands commands(app);
    declareCommands(commands);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const int status = app.exit(error);
        return status == 0 ? program::kDone : program::kUsage;
    }
    const program::StopOnSignal signals;
    return run(commands, signals.token());
}

} // namespace

} // namespace spherewalk::cli

int main(int argc, char** argv) {
    return spherewalk::cli::runProgram(argc, argv);
}
