// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "qt_application.h"
#include "temporary_folder.h"
#include "ui/capture/capture_mode.h"

#include "spherewalk/jobs/demo.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <string>

namespace spherewalk::ui {

/// A practice camera whose photos are drawn at once.
inline PracticeSettings fastPractice() {
    return {.width = 1024, .timeScale = 0.001, .keepsPhotos = false};
}

/// Remembers what was played.
class SilentSounds : public Sounds {
  public:
    explicit SilentSounds(std::vector<survey::Quality>& played) : m_played(played) {}

    void play(survey::Quality quality) override { m_played.push_back(quality); }

    void tick() override {}

  private:
    std::vector<survey::Quality>& m_played;
};

/// The capture page over a survey of the practice room with few stations.
class CaptureFixture : public testing::Test {
  protected:
    CaptureFixture() : mode(tasks) {
        jobs::newPracticeSurvey(path, 1.2);
        session = SurveySession::open(QString::fromStdString(path.string()));
        mode.setSession(session.get());
        desk().setPracticeSettings(fastPractice());
        mode.setSounds(std::make_unique<SilentSounds>(played));
        mode.resize(1280, 800);
        mode.show();
        QCoreApplication::processEvents(); // the first painting is not what is measured
    }

    ~CaptureFixture() override {
        tasks.stopAll();
        mode.setSession(nullptr);
    }

    CaptureDesk& desk() { return mode.desk(); }

    /// Runs the event loop until the condition holds.
    void waitUntil(const std::function<bool()>& holds) {
        QSignalSpy changes(&desk(), &CaptureDesk::changed);
        QElapsedTimer time;
        time.start();
        while (!holds()) {
            constexpr int kMostMs = 100'000;
            ASSERT_LT(time.elapsed(), kMostMs)
                << "state " << static_cast<int>(desk().state()) << ", " << desk().sentence().toStdString();
            changes.wait(50);
        }
    }

    void waitFor(CaptureDesk::State state) {
        waitUntil([&] { return desk().state() == state; });
    }

    void connectPractice() {
        desk().connectToPractice();
        waitFor(CaptureDesk::State::Ready);
    }

    test::TemporaryFolder folder;
    std::filesystem::path path = folder / "room.spherewalk";
    TaskList tasks;
    std::unique_ptr<SurveySession> session;
    std::vector<survey::Quality> played;
    CaptureMode mode;
};

} // namespace spherewalk::ui
