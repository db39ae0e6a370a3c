// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/camera/capture.h"

#include "capture/camera_options.h"
#include "options/command.h"
#include "options/terminal.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/jobs/follow_positions.h"
#include "spherewalk/jobs/judge_survey.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace spherewalk::cli {

namespace {

struct CaptureArguments {
    std::string survey;
    CameraOptions camera;
    bool practice = false;
    int most = 0;
    std::vector<std::string> again;
    std::optional<std::string> profile;
    std::string retakes = "none";
    double moveSeconds = 0;
    bool follow = false;
    double toleranceM = 0.03;
    bool byHand = false;
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

    bool walkOn(int photo, const std::stop_token& stop) override {
        waitingLines(); // as in ask()
        m_progress.warning(text("Photo ", photo, ": go to its place",
                                photo == 1 ? "" : ", about half a metre on",
                                ", then press Enter; q and Enter end the walk."));
        const auto answer = readLine(stop);
        throwIfStopped(stop);
        return answer && *answer != "q";
    }

    void placesFound(const jobs::PlacesFound& found) override { m_progress.warning(found.sentence()); }

    bool tryAgain(const store::StationRecord& /*station*/, const camera::ShotOutcome& /*outcome*/,
                  int /*tries*/, const std::stop_token& stop) override {
        ask("Press Enter to take the picture again.", stop);
        return true;
    }

  private:
    void ask(const std::string& sentence, const std::stop_token& stop) {
        waitingLines(); // a key that was pressed before the question is no answer to it
        m_progress.warning(sentence);
        if (!readLine(stop)) {
            throw Error(ErrorKind::Stopped,
                        "Standard input ended; the survey goes on where it stopped when capture is "
                        "started again.");
        }
    }

    ProgressSink& m_progress;
};

std::unique_ptr<jobs::Operator> operatorFor(const CaptureArguments& options, Context& context) {
    if (options.practice) {
        const std::chrono::duration<double> moveTime(options.moveSeconds);
        return std::make_unique<jobs::PracticeOperator>(
            options.camera.endpoint(), std::chrono::duration_cast<Clock::Duration>(moveTime));
    }
    return std::make_unique<PersonAtTerminal>(context.progress);
}

/// Those of the survey that are to be taken again, as far as asked for.
std::vector<std::int64_t> stationsToRetake(const store::SurveyStore& store, const std::string& which) {
    std::vector<std::int64_t> ids;
    for (const jobs::Retake& retake : which == "none" ? std::vector<jobs::Retake>() : jobs::retakes(store)) {
        if (which == "all" || (retake.isFailed && (which == "failed" || !retake.isSurrounded))) {
            ids.push_back(retake.station.id);
        }
    }
    return ids;
}

/// What is still to be done: with the stations, or with the places of photos by hand.
std::string leftWords(const jobs::CaptureSurveyReport& report) {
    if (!report.places) {
        return text(report.remaining, " of ", report.stations, " stations are still without a photo.");
    }
    return text(report.places->sentence(), report.places->placed.empty()
                                               ? ""
                                               : " align --positions free solves all of them in earnest.");
}

Result resultOf(const jobs::CaptureSurveyReport& report, const store::SurveyStore& store) {
    const int undecided = store.counts().unclearShots;
    const std::string notCompared =
        jobs::notComparedText(report.taken, report.notCompared, report.contentNotCompared);
    return {jobs::toJson(report),
            text("Took ", counted(report.taken, "photo", "photos"), " in ",
                 humanDuration(std::chrono::duration<double>(report.seconds)), report.places ? ". " : "; ",
                 leftWords(report),
                 report.flawed.empty()
                     ? ""
                     : text(" ", counted(report.flawed.size(), "photo is not good; review lists it.",
                                         "photos are not good; review lists them.")),
                 undecided == 0 ? ""
                                : text(" ", counted(undecided, "shot needs", "shots need"),
                                       " a person's decision; shots lists what can be done."),
                 notCompared.empty() ? "" : "\n", notCompared),
            report.missed.empty()};
}

/// A robot sends positions on standard input and is answered on standard output, a line each.
Result follow(const CaptureArguments& options, store::SurveyStore& store, camera::OscClient& client,
              Context& context) {
    jobs::FollowOptions followOptions{options.camera.captureOptions(), options.toleranceM};
    if (options.practice) {
        followOptions.camera = jobs::practiceCaptureOptions(options.camera.timeScale()).camera;
    }
    std::optional<jobs::PracticeOperator> cart;
    if (options.practice) {
        cart.emplace(options.camera.endpoint());
    }
    jobs::FollowLink link;
    link.nextLine = readLine;
    link.waitingLines = waitingLines;
    link.reached = [&](const store::StationRecord& station, const std::stop_token& stop) {
        if (cart) {
            cart->moveTo(station, stop);
        }
    };
    link.tell = [json = context.json](const jobs::FollowEvent& event) {
        const std::string words = json ? jobs::toJson(event).dump() : jobs::line(event);
        std::fprintf(stdout, "%s\n", words.c_str());
        std::fflush(stdout); // the robot waits for it
    };
    return resultOf(jobs::followPositions(store, client, link, systemClock(), followOptions, context.progress,
                                          context.stop),
                    store);
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

Result capture(const CaptureArguments& options, Context& context) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    const auto client = options.camera.client(context.stop);
    if (options.profile) {
        store.setCaptureProfile(survey::parseProfile(*options.profile));
    }
    if (options.follow) {
        return follow(options, store, *client, context);
    }
    const auto people = operatorFor(options, context);
    jobs::CaptureSurveyOptions captureOptions{options.camera.captureOptions()};
    if (options.practice) {
        captureOptions = jobs::practiceCaptureOptions(options.camera.timeScale());
    }
    captureOptions.most = options.most;
    captureOptions.byHand = options.byHand;
    captureOptions.again = stationsNamed(store, options.again);
    for (const std::int64_t station : stationsToRetake(store, options.retakes)) {
        captureOptions.again.push_back(station);
    }
    captureOptions.byHand |= captureOptions.again.empty() && jobs::isByHand(store);
    return resultOf(jobs::captureSurvey(store, *client, *people, systemClock(), captureOptions,
                                        context.progress, context.stop),
                    store);
}

} // namespace

void addCapture(Commands& commands) {
    const auto options = std::make_shared<CaptureArguments>();
    const program::Command command =
        commands.add("capture", "Take the photos that a survey still lacks",
                     [options](Context& context) { return capture(*options, context); });
    command.option("survey", options->survey, "Folder of the survey").required();
    options->camera.declare(command);
    command.flag("--practice", options->practice,
                 "The camera is a practice camera: bring it to each station by itself, without asking");
    command.flag(
        "--by-hand", options->byHand,
        "Take photos wherever the operator stands, and not at stations; align --positions free then solves "
        "where. A survey without rails is taken so in any case");
    command.option("--most", options->most, "Photos to take at most; 0: all that are missing")
        .notNegative()
        .showDefault();
    command.option("--again", options->again,
                   "Station to take besides, although it has a photo: \"rail 3, stop 5\"; can be repeated");
    command
        .option("--retakes", options->retakes,
                "Take flawed photos again besides: holes are failed ones that no neighbours stand in "
                "for, failed all that failed or were rejected, all the doubtful ones too")
        .among({"none", "holes", "failed", "all"})
        .showDefault();
    command
        .option("--move-time", options->moveSeconds,
                "Seconds that a practice cart takes from station to station")
        .range(0.0, 600.0);
    command.flag("--follow", options->follow,
                 "Take the photo of each station whose position arrives on standard input, as \"x y z\" "
                 "in metres or a JSON object with x, y and z, and answer on standard output");
    command
        .option("--tolerance", options->toleranceM,
                "With --follow: how far from its station a position may lie, metres")
        .showDefault();
    command.option("--profile", options->profile,
                   text("Change how the camera is set for this survey. ", kProfileHelp));
}

} // namespace spherewalk::cli
