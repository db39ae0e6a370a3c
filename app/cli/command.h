// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/base/progress.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <stop_token>
#include <string>

namespace spherewalk::cli {

/// What a command gets to run with.
struct Context {
    ProgressSink& progress; ///< shown on standard error
    std::stop_token stop;   ///< Ctrl-C
    bool json = false;      ///< standard output is for one JSON object only
};

/// What a command has to say: text for people, or the same as one JSON object.
struct Result {
    Json json = Json::object();
    std::string text;
    bool succeeded = true; ///< false: it ran, and what it found is bad (a check with findings); exit status 1
};

using Run = std::function<Result(Context&)>;

/// The commands of the program. Each add... function lives in a file of its own, declares its options, and
/// hands over what to run when its command is the one that was given.
class Commands {
  public:
    explicit Commands(CLI::App& app) : m_app(app) {}

    /// A new command with --json; a null parent makes a top level one.
    CLI::App& add(const std::string& name, const std::string& description, Run run,
                  CLI::App* parent = nullptr);
    /// A command that only groups others.
    CLI::App& addGroup(const std::string& name, const std::string& description);
    /// A flag of a group that is a command by itself, with --json.
    void addFlag(CLI::App& group, const std::string& flag, const std::string& description, Run run);

    bool json() const { return m_json; }

    const Run& chosen() const { return m_chosen; }

  private:
    CLI::App& m_app;
    bool m_json = false;
    Run m_chosen;
};

void addNew(Commands& commands);
void addPlan(Commands& commands);
void addCapture(Commands& commands);
void addImport(Commands& commands);
void addAlign(Commands& commands);
void addRetag(Commands& commands);
void addReview(Commands& commands);
void addStatus(Commands& commands);
void addCheck(Commands& commands);
void addExport(Commands& commands);
void addView(Commands& commands);
void addWalk(Commands& commands);
void addMeasure(Commands& commands);
void addGridStudy(Commands& commands);
void addCompare(Commands& commands);
void addBench(Commands& commands);
void addCamera(Commands& commands);
void addPracticeCamera(Commands& commands);
void addDemo(Commands& commands);

} // namespace spherewalk::cli
