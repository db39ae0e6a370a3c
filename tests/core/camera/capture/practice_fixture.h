// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "capture/memory_journal.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/camera/capture.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::test {

/// The whole picture must be decodable, as the program asks for.
inline camera::PhotoFacts decodeFile(const std::filesystem::path& file) {
    const RgbImage picture = jpeg::decode(readFile(file), file.string());
    return {picture.width(), picture.height()};
}

/// The capture workflow and a practice camera, a few hundred times as fast as a real one, over real HTTP.
class PracticeFixture : public testing::Test {
  protected:
    static constexpr double kScale = 0.005;

    PracticeFixture() {
        cameraOptions.width = 1024;
        cameraOptions.isPlain = true;
        cameraOptions.timeScale = kScale;
        captureOptions = camera::CaptureOptions{}.scaled(kScale);
        // A busy machine is slower than the camera.
        captureOptions.allowance.base = std::chrono::milliseconds(600);
        captureOptions.confirmTime = std::chrono::milliseconds(100);
        captureOptions.idleTime = std::chrono::seconds(5);
        captureOptions.reconnectTime = std::chrono::seconds(10);
        captureOptions.download.check = decodeFile;
        captureOptions.profile = survey::parseProfile("iso=200,shutter=1/50,white-balance=5000K");
        oscOptions = camera::OscOptions{}.scaled(kScale);
        oscOptions.http.requestTimeout = std::chrono::milliseconds(400);
        oscOptions.http.stallTimeout = std::chrono::milliseconds(300);
        oscOptions.statusTimeout = std::chrono::milliseconds(400);
    }

    void runCamera() {
        m_camera.emplace(cameraOptions);
        m_camera->start();
        start();
    }

    /// The program begins anew; whatever the old one remembered is gone.
    void start() {
        m_capture.reset();
        client = std::make_unique<camera::OscClient>(camera::Endpoint{"127.0.0.1", practice().port()},
                                                     oscOptions, systemClock());
        m_capture = std::make_unique<camera::Capture>(*client, journal, systemClock(), captureOptions);
    }

    practice::PracticeCamera& practice() { return *m_camera; }

    camera::Capture& capture() { return *m_capture; }

    void arm(practice::FaultKind kind, const std::string& on, int count = 1, double amount = 0) {
        practice().arm({kind, on, 0, count, 0, amount});
    }

    camera::ShotOutcome shoot(int station) {
        practice().setPosition({double(station), 0, 1});
        return capture().shoot(station, {});
    }

    std::vector<practice::Truth> truths() const {
        const bool hasAny = std::filesystem::exists(m_camera->truthFile());
        return hasAny ? practice::readTruth(m_camera->truthFile()) : std::vector<practice::Truth>();
    }

    int exposuresOf(int station) const {
        const std::vector<practice::Truth> all = truths();
        return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const practice::Truth& truth) {
            return truth.nominalPositionM.x() == station && !truth.byButton;
        }));
    }

    /// The shot's photo is one that the camera took at its station, with the profile's exposure.
    void expectRightPhoto(const camera::ShotOutcome& outcome) {
        ASSERT_EQ(outcome.shot.step, survey::ShotStep::Downloaded) << outcome.sentence;
        const std::string sha256 = sha256Hex(journal.photos.at(outcome.shot.id));
        const std::vector<practice::Truth> all = truths();
        const auto found = std::find_if(all.begin(), all.end(),
                                        [&](const practice::Truth& truth) { return truth.sha256 == sha256; });
        ASSERT_NE(found, all.end());
        EXPECT_EQ(found->nominalPositionM.x(), double(outcome.shot.station));
        EXPECT_EQ(found->options["iso"], 200) << found->options;
        EXPECT_EQ(found->options["_colorTemperature"], 5000);
        EXPECT_FALSE(found->byButton);
    }

    TemporaryFolder folder;
    EventLog log;
    MemoryJournal journal{systemClock(), log, folder.path()};
    practice::PracticeCameraOptions cameraOptions;
    camera::CaptureOptions captureOptions;
    camera::OscOptions oscOptions;
    std::unique_ptr<camera::OscClient> client;

  private:
    std::optional<practice::PracticeCamera> m_camera;
    std::unique_ptr<camera::Capture> m_capture;
};

} // namespace spherewalk::test
