// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "program/command_line.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"

#include <filesystem>
#include <functional>
#include <stop_token>
#include <string>

namespace spherewalk::store {
class SurveyStore;
struct PhotoRecord;
} // namespace spherewalk::store

namespace spherewalk::cli {

/// What a command gets to run with.
struct Context {
    ProgressSink& progress; ///< The sink shows progress and warnings on standard error.
    std::stop_token stop;   ///< Ctrl-C requests the stop.
    bool json = false;      ///< Standard output is for one JSON object only.
};

/// What a command has to say, as text for people and as one JSON object with the same content.
struct Result {
    Json json = Json::object();
    std::string text;
    bool succeeded = true; ///< False: the command ran and found something bad. The exit status is 1.
};

using Run = std::function<Result(Context&)>;

/// The commands of the program. Each add... function below declares a command with its options, and hands
/// over the function that runs it.
class Commands {
  public:
    explicit Commands(program::Command program) : m_program(program) { m_program.requireCommand(); }

    /// Declares a command of the program, with --json.
    program::Command add(const std::string& name, const std::string& help, Run run) {
        return add(m_program, name, help, std::move(run));
    }

    /// Declares a command within a group, with --json.
    program::Command add(const program::Command& group, const std::string& name, const std::string& help,
                         Run run);
    /// Declares a command that groups others; the user gives one of them.
    program::Command addGroup(const std::string& name, const std::string& help);
    /// Declares a flag of a group that is a command by itself, with --json.
    void addFlag(const program::Command& group, const std::string& flag, const std::string& help, Run run);

    bool json() const { return m_json; }

    /// Empty until the command line is parsed.
    const Run& chosen() const { return m_chosen; }

  private:
    void declareJson(const program::Command& command);

    program::Command m_program;
    bool m_json = false;
    Run m_chosen;
};

/// Declares --tolerance, in pixels of the robot's camera.
void declareTolerance(const program::Command& command, double& tolerancePx);

/// Checks the file's name before minutes are spent on what it will show. An empty name is fine: there will be
/// no plot. Errors: InvalidInput for a name that does not end in .svg; NotFound for a missing folder.
void checkPlot(const std::filesystem::path& plot);

/// Writes the picture and adds the file's name to the result. Errors: Io.
void writePlot(const std::string& plot, const std::string& svg, Result& result);

/// The photo that a person names: by its file, its number, or its station, whose chosen photo it is. Errors:
/// NotFound.
store::PhotoRecord photoNamed(const store::SurveyStore& store, const std::string& name);

/// The help for options that take a capture profile.
inline constexpr const char* kProfileHelp =
    "auto: by the camera, photo by photo; camera: as it is; or what is to be fixed, with commas between: "
    "iso=200, shutter=1/60, ev=-0.3, white-balance=daylight or 5200K, width=5376";

void addNew(Commands& commands);
void addPlan(Commands& commands);
void addCapture(Commands& commands);
void addImport(Commands& commands);
void addAlign(Commands& commands);
void addRetag(Commands& commands);
void addReview(Commands& commands);
void addPrivacy(Commands& commands);
void addStatus(Commands& commands);
void addShots(Commands& commands);
void addCheck(Commands& commands);
void addExport(Commands& commands);
void addView(Commands& commands);
void addWalk(Commands& commands);
void addProbe(Commands& commands);
void addMeasure(Commands& commands);
void addGridStudy(Commands& commands);
void addCompare(Commands& commands);
void addBench(Commands& commands);
void addCamera(Commands& commands);
void addPracticeCamera(Commands& commands);
void addPracticePictures(Commands& commands);
void addDemo(Commands& commands);

} // namespace spherewalk::cli
