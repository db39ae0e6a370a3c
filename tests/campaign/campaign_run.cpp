// SPDX-License-Identifier: GPL-3.0-or-later
#include "campaign_run.h"

#include "fault_script.h"
#include "program.h"
#include "random.h"
#include "temporary_folder.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <thread>

namespace spherewalk::campaign {

namespace {

using namespace std::chrono_literals;
using Steady = std::chrono::steady_clock;

constexpr const char* kProfile = "iso=200,shutter=1/50,white-balance=5000K";
constexpr double kTimeScale = 0.01;
constexpr std::chrono::seconds kHangs = 180s; ///< longer than all timeouts of one shot together
/// Nobody carries a cart on within the time in which a trigger that was lost can have begun a picture.
constexpr std::chrono::seconds kCarried = 14s;
constexpr int kTroubledPrograms = 6;
constexpr int kLastPrograms = 8;

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
          m_survey(m_folder / (m_random.integer(0, 1) == 0
                                   ? "s.spherewalk"
                                   : "R\xc3\xa4ume, 2. Stock \xe6\xb8\xac.spherewalk")) {
        m_report.seed = options.seed;
    }

    RunReport run() {
        std::filesystem::copy(m_options.templateSurvey, m_survey, std::filesystem::copy_options::recursive);
        practice::PracticeCameraOptions cameraOptions = randomCamera(m_random, m_folder.path());
        cameraOptions.timeScale = kTimeScale;
        practice::PracticeCamera camera(cameraOptions);
        camera.start();
        m_command = {m_options.cli,   "capture",  m_survey.string(),
                     "--practice",    "--camera", text("127.0.0.1:", camera.port()),
                     "--profile",     kProfile,   "--time-scale",
                     text(kTimeScale)};
        for (int i = 0; i < kTroubledPrograms && !isComplete(); ++i) {
            armScript(camera);
            trouble(camera);
            moveOn(camera);
        }
        camera.disarm();
        for (int i = 0; i < kLastPrograms && !isComplete(); ++i) {
            test::Program program(m_command);
            ++m_report.programs;
            if (expectEnd(program) != 0) { // what its sentences ask for
                camera.befall({practice::FaultKind::Reboot, "", 0, 1, 0, 3});
            }
        }
        camera.stop();
        if (!isComplete()) {
            m_report.findings.violations.push_back("the last program said: " + m_lastWords);
        }
        expectSoundDataset();
        Findings findings = examine(m_survey, m_folder / "truth.jsonl", profileOptions(), m_said);
        for (std::string& violation : m_report.findings.violations) {
            findings.violations.push_back(std::move(violation));
        }
        m_report.findings = std::move(findings);
        return std::move(m_report);
    }

  private:
    bool isComplete() const {
        return store::SurveyStore::open(m_survey, store::Access::Read).stationsWithoutPhoto().empty();
    }

    /// What a simulator gets says the same places as the survey.
    void expectSoundDataset() {
        const std::string dataset = (m_folder / "dataset").string();
        for (const std::vector<std::string>& command :
             {std::vector<std::string>{m_options.cli, "export", m_survey.string(), dataset},
              std::vector<std::string>{m_options.cli, "check", dataset}}) {
            test::Program program(command);
            if (program.wait() != 0) {
                m_report.findings.violations.push_back(
                    text(command[1], " said: ", program.errors(), program.output()));
            }
        }
    }

    void armScript(practice::PracticeCamera& camera) {
        if (m_random.integer(0, 3) == 0) {
            camera.disarm(); // somebody has put right what was wrong
        }
        for (const practice::Fault& fault : randomScript(m_random)) {
            ++m_report.faults[std::string(practice::name(fault.kind))];
            camera.arm(fault);
        }
    }

    /// One program, which is killed, stopped, left alone, or has its camera switched off and on.
    void trouble(practice::PracticeCamera& camera) {
        test::Program program(m_command);
        ++m_report.programs;
        const std::chrono::milliseconds patience(m_random.integer(5, 2000));
        switch (m_random.integer(0, 5)) {
        case 0:
        case 1:
            if (!program.endsWithin(patience)) {
                program.signal(SIGKILL);
                ++m_report.kills;
            }
            program.wait();
            m_said += program.errors();
            return;
        case 2:
            if (!program.endsWithin(patience)) {
                interrupt(program);
            }
            break;
        case 3:
            if (!program.endsWithin(patience)) {
                camera.befall({practice::FaultKind::Reboot, "", 0, 1, 0, m_random.uniform(1, 15)});
                ++m_report.powerCycles;
            }
            break;
        default:
            break;
        }
        expectEnd(program);
    }

    /// Between two programs people move the cart, and may press the camera's own button.
    void moveOn(practice::PracticeCamera& camera) {
        const bool isInDoubt = hasShotInDoubt(); // then it would do the most harm
        if (!isInDoubt && m_random.integer(0, 1) == 0) {
            return;
        }
        camera.setPosition({m_random.uniform(0.2, 1.8), m_random.uniform(0.2, 1.4), 1.2});
        if (!isInDoubt && m_random.integer(0, 2) > 0) {
            return;
        }
        if (isInDoubt) {
            std::this_thread::sleep_for(kCarried);
        }
        camera.befall({practice::FaultKind::ExtraPhoto, "", 0, 1, 0, 0});
        ++m_report.faults["button between programs"];
    }

    /// Whether a picture may be taken for that of a shot.
    bool hasShotInDoubt() const {
        const auto shots = store::SurveyStore::open(m_survey, store::Access::Read).openShots();
        return std::ranges::any_of(
            shots, [](const survey::Shot& shot) { return shot.step < survey::ShotStep::Taken; });
    }

    void interrupt(test::Program& program) {
        const auto begin = Steady::now();
        program.signal(SIGINT);
        if (program.endsWithin(kHangs)) {
            m_report.stopSeconds.push_back(std::chrono::duration<double>(Steady::now() - begin).count());
        }
    }

    /// However it ends, it ends, and says why. Its exit status.
    int expectEnd(test::Program& program) {
        if (!program.endsWithin(kHangs)) {
            m_report.findings.violations.push_back("a program does not end: " + program.errors());
            program.signal(SIGKILL);
        }
        const int status = program.wait();
        m_lastWords = program.errors();
        m_said += m_lastWords;
        constexpr int kInterrupted = 128 + SIGINT; // before it could do better
        if (status > 100 && status != kInterrupted) {
            m_report.findings.violations.push_back(
                text("a program ended with status ", status, ": ", program.errors()));
        }
        return status;
    }

    RunOptions m_options;
    test::Random m_random;
    test::TemporaryFolder m_folder;
    std::filesystem::path m_survey;
    std::vector<std::string> m_command;
    std::string m_said;
    std::string m_lastWords;
    RunReport m_report;
};

} // namespace

RunReport run(const RunOptions& options) {
    return Run(options).run();
}

} // namespace spherewalk::campaign
