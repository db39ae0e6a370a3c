// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera_options.h"
#include "command.h"
#include "profile_help.h"
#include "terminal.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/jobs/operators.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

namespace spherewalk::cli {

namespace {

struct Options {
    std::string survey;
    CameraOptions camera;
    bool practice = false;
    int most = 0;
    std::vector<std::string> again;
    std::optional<std::string> profile;
};

/// A person at the terminal, who brings the camera to the station and presses Enter.
class PersonAtTerminal : public jobs::Operator {
  public:
    explicit PersonAtTerminal(ProgressSink& progress) : m_progress(progress) {}

    void moveTo(const store::StationRecord& station, const std::stop_token& stop) override {
        const Eigen::Vector3d& p = station.station.positionM;
        ask(text("Bring the camera to ", station.name, " (x ", fixed(p.x(), 3), ", y ", fixed(p.y(), 3),
                 ", z ", fixed(p.z(), 3), "), then press Enter."),
            stop);
    }

    bool tryAgain(const store::StationRecord& /*station*/, const camera::ShotOutcome& outcome, int /*tries*/,
                  const std::stop_token& stop) override {
        ask(text(outcome.sentence, " Press Enter to take the picture again."), stop);
        return true;
    }

  private:
    void ask(const std::string& sentence, const std::stop_token& stop) {
        m_progress.warning(sentence);
        if (!readLine(stop)) {
            throw Error(ErrorKind::Stopped,
                        "Standard input ended; the survey goes on where it stopped when capture is "
                        "started again.");
        }
    }

    ProgressSink& m_progress;
};

std::unique_ptr<jobs::Operator> operatorFor(const Options& options, Context& context) {
    if (options.practice) {
        return std::make_unique<jobs::PracticeOperator>(options.camera.endpoint());
    }
    return std::make_unique<PersonAtTerminal>(context.progress);
}

/// Errors: NotFound for a name that no station has.
std::vector<std::int64_t> stationsNamed(const store::SurveyStore& store,
                                        const std::vector<std::string>& names) {
    const std::vector<store::StationRecord> stations = store.stations();
    std::vector<std::int64_t> ids;
    for (const std::string& name : names) {
        const auto found =
            std::find_if(stations.begin(), stations.end(),
                         [&](const store::StationRecord& station) { return station.name == name; });
        if (found == stations.end()) {
            throw Error(ErrorKind::NotFound, text("The survey has no station \"", printable(name),
                                                  "\"; plan --json lists their names."));
        }
        ids.push_back(found->id);
    }
    return ids;
}

Result capture(const Options& options, Context& context) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    const auto client = options.camera.client(context.stop);
    const auto people = operatorFor(options, context);
    jobs::CaptureSurveyOptions captureOptions{options.camera.captureOptions()};
    if (options.practice) {
        captureOptions = jobs::practiceCaptureOptions(options.camera.timeScale());
    }
    captureOptions.most = options.most;
    if (options.profile) {
        store.setCaptureProfile(survey::parseProfile(*options.profile));
    }
    captureOptions.again = stationsNamed(store, options.again);
    const jobs::CaptureSurveyReport report = jobs::captureSurvey(
        store, *client, *people, systemClock(), captureOptions, context.progress, context.stop);
    return {jobs::toJson(report),
            text("Took ", report.taken, " photos in ",
                 humanDuration(std::chrono::duration<double>(report.seconds)), "; ", report.remaining, " of ",
                 report.stations, " stations are still without a photo."),
            report.missed.empty()};
}

} // namespace

void addCapture(Commands& commands) {
    const auto options = std::make_shared<Options>();
    CLI::App& command = commands.add("capture", "Take the photos that a survey still lacks",
                                     [options](Context& context) { return capture(*options, context); });
    command.add_option("survey", options->survey, "Folder of the survey")->required();
    options->camera.declare(command);
    command.add_flag("--practice", options->practice,
                     "The camera is a practice camera: bring it to each station by itself, without asking");
    command.add_option("--most", options->most, "Photos to take at most; 0: all that are missing")
        ->check(CLI::NonNegativeNumber)
        ->capture_default_str();
    command.add_option(
        "--again", options->again,
        "Station to take besides, although it has a photo: \"rail 3, stop 5\"; can be repeated");
    command.add_option("--profile", options->profile,
                       text("Change how the camera is set for this survey. ", kProfileHelp));
}

} // namespace spherewalk::cli
