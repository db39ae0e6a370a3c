// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "capture/memory_journal.h"
#include "capture/test_camera.h"
#include "manual_clock.h"
#include "temporary_folder.h"

#include "spherewalk/camera/capture.h"

#include <gtest/gtest.h>

#include <memory>

namespace spherewalk::test {

/// A program with its own connection and memory; the journal and the camera outlive it.
struct Program {
    Program(const TestCamera& camera, MemoryJournal& journal, ManualClock& clock,
            const camera::CaptureOptions& options)
        : client(camera::parseEndpoint(camera.address()), quick(), clock),
          capture(client, journal, clock, options) {}

    static camera::OscOptions quick() {
        camera::OscOptions options;
        options.http.requestTimeout = std::chrono::milliseconds(200);
        options.http.stallTimeout = std::chrono::milliseconds(200);
        options.statusTimeout = std::chrono::milliseconds(200);
        return options;
    }

    camera::OscClient client;
    camera::Capture capture;
};

class CaptureFixture : public testing::Test {
  protected:
    CaptureFixture() {
        options.download.check = checkJpeg;
        camera.addFile();
        camera.addFile();
        start();
    }

    /// Starts the program anew; whatever the old one remembered is gone.
    void start() {
        program.reset();
        program = std::make_unique<Program>(camera, journal, clock, options);
    }

    camera::Capture& capture() { return program->capture; }

    const survey::Shot& lastShot() const { return journal.shots.rbegin()->second; }

    /// The photo that the journal has for the shot is the camera's file of this index.
    void expectPhoto(std::int64_t shot, std::size_t fileIndex) {
        ASSERT_TRUE(journal.photos.contains(shot));
        ASSERT_LT(fileIndex, camera.files.size());
        EXPECT_EQ(textOf(journal.photos[shot]), camera.files[fileIndex].bytes);
        EXPECT_EQ(camera::pathOfUrl(journal.shots[shot].fileUrl), camera.files[fileIndex].path);
    }

    int triggers() const { return camera.count("camera.takePicture"); }

    /// The next pictures differ, so that a mix-up shows.
    void nextPhotoLooks(char like) { camera.nextPhoto.replace(100, 50, 50, like); }

    TemporaryFolder folder;
    ManualClock clock;
    EventLog log;
    TestCamera camera{clock, log};
    MemoryJournal journal{clock, log, folder.path()};
    camera::CaptureOptions options;
    std::unique_ptr<Program> program;
};

inline TestCamera::Fault answering(const ServerAction& action) {
    return [action](const auto&) { return action; };
}

/// The camera does what it was asked to, but its answer is lost.
inline TestCamera::Fault losingTheAnswer() {
    return [](const std::function<ServerAction()>& normal) {
        normal();
        return closeSilently();
    };
}

} // namespace spherewalk::test
