// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign_run.h"

#include "fault_script.h"
#include "hand_work.h"
#include "program.h"
#include "random.h"
#include "run_cameras.h"
#include "temporary_folder.h"
#include "terminal_person.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>

namespace spherewalk::campaign {

namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

constexpr const char* kProfile = "iso=200,shutter=1/50,white-balance=5000K";
constexpr double kTimeScale = 0.01;
constexpr double kPersonsTimeScale = 0.3; ///< A busy machine must not look like a camera that is too slow.
constexpr std::chrono::seconds kHangs = 600s;   ///< longer than all timeouts of one survey together
constexpr std::chrono::seconds kSlowStop = 20s; ///< also on a machine that does much else
/// Nobody carries a cart on within the time in which a trigger that was lost can have begun a picture.
constexpr std::chrono::seconds kCarried = 14s;
constexpr int kTroubledPrograms = 7;
constexpr int kLastPrograms = 8;
constexpr const char* kOtherFileSystem = "/dev/shm";

Json profileOptions() {
    return {{"exposureProgram", 1},
            {"iso", 200},
            {"shutterSpeed", 0.02},
            {"whiteBalance", "_colorTemperature"},
            {"_colorTemperature", 5000}};
}

class Run {
  public:
    explicit Run(const RunOptions& options)
        : m_options(options),
          m_random(options.seed),
          m_name(m_random.integer(0, 1) == 0 ? "s.spherewalk"
                                             : "R\xc3\xa4ume, 2. Stock \xe6\xb8\xac.spherewalk"),
          m_survey(m_folder / m_name),
          m_isDrawn(options.seed % 8 == 0),
          m_standsWrong(options.seed % 3 == 0),
          m_exposure(profileOptions()),
          m_cameras(m_random, m_folder.path(), kTimeScale, m_isDrawn),
          m_people(options.cli, m_cameras, m_random, m_folder.path(), m_exposure) {
        m_report.seed = options.seed;
        if (fs::is_directory(kOtherFileSystem)) {
            m_elsewhere.emplace(kOtherFileSystem);
        }
    }

    RunReport run() {
        fs::copy(m_options.templateSurvey, m_survey, fs::copy_options::recursive);
        for (int i = 0; i < kTroubledPrograms; ++i) {
            armScript();
            trouble();
            m_cameras.look();
            betweenPrograms();
            expectRightPlaces();
        }
        m_cameras.disarm();
        finish();
        m_cameras.look();
        conclude();
        m_cameras.stop();
        if (!m_options.keepIn.empty() && !m_report.findings.violations.empty()) {
            keep(m_options.keepIn / std::to_string(m_options.seed));
        }
        return std::move(m_report);
    }

  private:
    Evidence evidence() const { return {m_cameras, m_people, m_exposure, m_said, m_standsWrong}; }

    store::SurveyStore opened() const { return store::SurveyStore::open(m_survey, store::Access::Read); }

    void violate(std::string sentence) { m_violations.push_back(std::move(sentence)); }

    void did(const std::string& deed) { ++m_report.deeds[deed]; }

    bool isOneOf(int many) { return m_random.integer(1, many) == 1; }

    std::vector<std::string> command(const std::string& address, bool byPerson) {
        std::vector<std::string> words{
            m_options.cli, "capture",      m_survey.string(),
            "--camera",    address,        "--profile",
            kProfile,      "--time-scale", text(byPerson ? kPersonsTimeScale : kTimeScale)};
        if (!byPerson) {
            words.emplace_back("--practice");
        }
        return words;
    }

    /// At times, a station is taken again that has a photo.
    void takeAgain(std::vector<std::string>& words) {
        const auto photos = opened().chosenPhotos();
        if (!photos.empty() && isOneOf(5)) {
            did("stations taken again");
            words.emplace_back("--again");
            words.push_back(opened().station(photos.front().station).name);
        }
    }

    void armScript() {
        if (isOneOf(4)) {
            m_cameras.disarm(); // somebody has put right what was wrong
        }
        for (const practice::Fault& fault : randomScript(m_random)) {
            ++m_report.faults[std::string(practice::name(fault.kind))];
            m_cameras.atHand().arm(fault);
        }
    }

    std::map<std::string, Eigen::Vector3d> placesOfStations() const {
        std::map<std::string, Eigen::Vector3d> places;
        for (const store::StationRecord& station : opened().stations()) {
            places[station.name] = station.station.positionM;
        }
        return places;
    }

    /// Brings the camera to the station, or to one that was not asked for.
    void bringCamera(const std::map<std::string, Eigen::Vector3d>& places, const std::string& station) {
        const Eigen::Vector3d& asked = places.at(station);
        Eigen::Vector3d place = asked;
        if (m_standsWrong && isOneOf(8)) {
            place =
                std::next(places.begin(), m_random.integer(0, static_cast<int>(places.size()) - 1))->second;
            m_people.noteWrongPlace(asked, place);
            did("carts at a wrong station");
        }
        m_cameras.atHand().setPosition(place);
    }

    /// One program, which is killed, stopped, left alone, or has its camera switched off and on.
    void trouble() {
        const bool byPerson = isOneOf(3);
        std::vector<std::string> words = command(m_cameras.address(), byPerson);
        takeAgain(words);
        std::optional<TerminalPerson> person;
        test::Program::Options input;
        if (byPerson) {
            did("programs with a person at the terminal");
            const auto places = placesOfStations();
            person.emplace(TerminalPerson::Habits{
                [this, places](const std::string& station) { bringCamera(places, station); },
                [this] { return isOneOf(2) ? 1 : 3; }});
            input.inputFile = person->terminal();
        }
        test::Program program(words, input);
        ++m_report.programs;
        m_person = person ? &*person : nullptr;
        std::optional<test::Program> second;
        if (m_cameras.count() > 1 && isOneOf(3)) {
            did("captures with both cameras at a time");
            second.emplace(command(m_cameras.otherAddress(), false));
        }
        disturb(program);
        m_person = nullptr;
        if (second) {
            expectEnd(*second);
        }
    }

    void disturb(test::Program& program) {
        const std::chrono::milliseconds patience(m_random.integer(5, 2000));
        switch (m_random.integer(0, 5)) {
        case 0:
        case 1:
            if (!endsWithin(program, patience)) {
                program.signal(SIGKILL);
                ++m_report.kills;
            }
            program.wait();
            m_said += program.errors();
            return;
        case 2:
            if (!endsWithin(program, patience)) {
                interrupt(program);
            }
            break;
        case 3:
            if (!endsWithin(program, patience)) {
                m_cameras.atHand().befall(
                    {practice::FaultKind::Reboot, "", 0, 1, 0, m_random.uniform(1, 15)});
                ++m_report.powerCycles;
            }
            break;
        default:
            break;
        }
        expectEnd(program);
    }

    /// While a person, if there is one, does what it says.
    bool endsWithin(const test::Program& program, std::chrono::milliseconds time) {
        return m_person == nullptr ? program.endsWithin(time) : m_person->attend(program, time);
    }

    /// Between two programs people move the cart, press the camera's own button, and work by hand.
    void betweenPrograms() {
        moveOn();
        if (isOneOf(3)) {
            m_people.import(m_survey);
        }
        if (isOneOf(4)) {
            m_people.retag(m_survey);
        }
        if (isOneOf(3)) {
            m_people.decide(m_survey, false);
        }
        if (m_isDrawn && isOneOf(3)) {
            m_people.align(m_survey);
        }
        if (isOneOf(3)) {
            m_people.correct(m_survey);
        }
        if (m_elsewhere && isOneOf(4)) {
            carrySurvey();
        }
        if (isOneOf(4)) {
            did("changes of the camera");
            std::vector<Eigen::Vector3d> places;
            for (const auto& [name, place] : placesOfStations()) {
                places.push_back(place);
            }
            m_cameras.change(places);
        }
    }

    /// To another file system and back, as whatever the last program has left.
    void carrySurvey() {
        did("copies to another file system");
        const bool isHome = m_survey.parent_path() == m_folder.path();
        const fs::path target = (isHome ? m_elsewhere->path() : m_folder.path()) / m_name;
        fs::copy(m_survey, target, fs::copy_options::recursive);
        fs::remove_all(m_survey);
        m_survey = target;
    }

    void moveOn() {
        const bool isInDoubt = hasShotInDoubt(); // then it would do the most harm
        if (!isInDoubt && isOneOf(2)) {
            return;
        }
        m_cameras.atHand().setPosition({m_random.uniform(0.2, 1.8), m_random.uniform(0.2, 1.4), 1.2});
        if (!isInDoubt && !isOneOf(3)) {
            return;
        }
        if (isInDoubt) {
            std::this_thread::sleep_for(kCarried);
        }
        m_cameras.atHand().befall({practice::FaultKind::ExtraPhoto, "", 0, 1, 0, 0});
        ++m_report.faults[isInDoubt ? kButtonInDoubt : "button between programs"];
    }

    /// Whether a picture may be taken for that of a shot.
    bool hasShotInDoubt() const {
        const auto shots = opened().openShots();
        return std::ranges::any_of(
            shots, [](const survey::Shot& shot) { return shot.step < survey::ShotStep::Taken; });
    }

    void interrupt(test::Program& program) {
        const auto begin = Steady::now();
        program.signal(SIGINT);
        if (endsWithin(program, kHangs)) {
            const std::chrono::duration<double> taken = Steady::now() - begin;
            m_report.stopSeconds.push_back(taken.count());
            if (taken > kSlowStop) {
                violate(text("a program took ", fixed(taken.count(), 1), " s to stop: ", program.errors()));
            }
        }
    }

    /// However it ends, it ends, and says why. Its exit status.
    int expectEnd(test::Program& program) {
        if (!endsWithin(program, kHangs)) {
            violate("a program does not end: " + program.errors());
            program.signal(SIGKILL);
        }
        const int status = program.wait();
        m_lastWords = program.errors();
        m_said += m_lastWords;
        constexpr int kInterrupted = 128 + SIGINT; // before it could do better
        if (status > 100 && status != kInterrupted) {
            violate(text("a program ended with status ", status, ": ", program.errors()));
        }
        return status;
    }

    void expectRightPlaces() {
        for (std::string& sentence : wrongPlaces(m_survey, evidence())) {
            violate(std::move(sentence));
        }
    }

    bool isComplete() const {
        const store::SurveyStore store = opened();
        return store.stationsWithoutPhoto().empty() && store.unclearShots().empty() &&
               store.openShots().empty();
    }

    int captureQuietly(const std::string& address) {
        test::Program program(command(address, false));
        ++m_report.programs;
        return expectEnd(program);
    }

    /// With nothing going wrong any more, the survey is brought to its end by what the programs' sentences
    /// ask for.
    void finish() {
        for (int i = 0; i < kLastPrograms; ++i) {
            m_people.correct(m_survey);
            m_people.decide(m_survey, i >= kLastPrograms / 2);
            if (isComplete()) {
                break;
            }
            for (const std::string& address : {m_cameras.address(), m_cameras.otherAddress()}) {
                if (captureQuietly(address) != 0) {
                    m_cameras.atHand().befall({practice::FaultKind::Reboot, "", 0, 1, 0, 3});
                }
            }
        }
        if (!isComplete()) {
            violate("the last program said: " + m_lastWords);
        } else if (captureQuietly(m_cameras.address()) != 0) {
            violate("nothing is left to do, and capture still says: " + m_lastWords);
        }
    }

    /// What the truth says of the survey, and of the dataset that a simulator gets.
    void conclude() {
        if (m_isDrawn) {
            m_people.align(m_survey);
        }
        const fs::path dataset = m_folder / "dataset";
        const Answer exported =
            m_people.run({"export", m_survey.string(), dataset.string(), "--scene", "sphere"});
        Findings findings = examine(m_survey, evidence());
        if (exported.status != 0) {
            violate("export said: " + exported.errors);
        } else {
            examineDataset(dataset, m_cameras, exported.errors, findings);
            const Answer checked = m_people.run({"check", dataset.string()});
            if (checked.status != 0) {
                violate("check said of the dataset: " + checked.output + checked.errors);
            }
        }
        for (const auto& list : {m_violations, m_people.violations()}) {
            findings.violations.insert(findings.violations.end(), list.begin(), list.end());
        }
        m_report.findings = std::move(findings);
        for (const auto& [deed, count] : m_people.counts()) {
            m_report.deeds[deed] += count;
        }
    }

    /// The survey, the dataset, the cameras' pictures with their truth, and all that the programs said.
    void keep(const fs::path& folder) const {
        fs::create_directories(folder);
        fs::copy(m_folder.path(), folder, fs::copy_options::recursive | fs::copy_options::overwrite_existing);
        if (m_survey.parent_path() != m_folder.path()) {
            fs::copy(m_survey, folder / m_name, fs::copy_options::recursive);
        }
        writeFile(folder / "said.txt", bytesOf(m_said));
    }

    RunOptions m_options;
    test::Random m_random;
    test::TemporaryFolder m_folder;
    std::optional<test::TemporaryFolder> m_elsewhere; ///< in another file system, if there is one
    std::string m_name;
    fs::path m_survey;
    bool m_isDrawn;     ///< The pictures show a room, so that they can be aligned.
    bool m_standsWrong; ///< The person brings the camera to a wrong station at times.
    Json m_exposure;
    RunCameras m_cameras;
    HandWork m_people;
    TerminalPerson* m_person = nullptr; ///< who attends the program that runs
    std::string m_said;
    std::string m_lastWords;
    std::vector<std::string> m_violations;
    RunReport m_report;
};

} // namespace

RunReport run(const RunOptions& options) {
    return Run(options).run();
}

} // namespace spherewalk::campaign
