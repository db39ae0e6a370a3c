// SPDX-License-Identifier: GPL-3.0-or-later
#include "command.h"
#include "terminal.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <cstdio>
#include <exception>
#include <string>

namespace spherewalk::cli {

namespace {

enum ExitStatus { kDone = 0, kFailed = 1, kUsage = 2, kStopped = 3 };

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

void print(std::FILE* stream, const std::string& line) {
    std::fputs((line + "\n").c_str(), stream);
}

int fail(const Error& error, bool json) {
    if (json) {
        const Json report = {{"error", {{"kind", name(error.kind())}, {"sentence", error.sentence()}}}};
        print(stdout, report.dump());
    }
    print(stderr, error.sentence());
    if (!error.context().empty()) {
        print(stderr, text("  (", error.context(), ")"));
    }
    return error.kind() == ErrorKind::Stopped ? kStopped : kFailed;
}

int run(const Commands& commands, const std::stop_token& stop) {
    try {
        TerminalProgress progress;
        Context context{progress, stop, commands.json()};
        const Result result = commands.chosen()(context);
        print(stdout, commands.json() ? result.json.dump() : result.text);
        return result.succeeded ? kDone : kFailed;
    } catch (const Error& error) {
        return fail(error, commands.json());
    } catch (const std::exception& defect) { // whatever no module translated
        return fail(
            Error(ErrorKind::Internal, text("Spherewalk met a defect of its own: ", defect.what(), ".")),
            commands.json());
    }
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
        return status == 0 ? kDone : kUsage;
    }
    const StopOnSignal signals;
    return run(commands, signals.token());
}

} // namespace

} // namespace spherewalk::cli

int main(int argc, char** argv) {
    return spherewalk::cli::runProgram(argc, argv);
}
