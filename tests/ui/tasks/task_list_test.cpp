// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/tasks/task.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"

#include <QCoreApplication>
#include <QSignalSpy>
#include <gtest/gtest.h>

#include <atomic>

namespace spherewalk::ui {

namespace {

using namespace std::chrono_literals;

void waitForEnd(Task* task) {
    if (task->isRunning()) {
        QSignalSpy ended(task, &Task::ended);
        ASSERT_TRUE(ended.wait(100'000));
    }
}

/// A job that goes on until it is stopped.
void runUntilStopped(ProgressSink& /*progress*/, const std::stop_token& stop) {
    systemClock().sleep(1h, stop);
    throwIfStopped(stop);
}

} // namespace

TEST(TaskList, DeliversTheResultOnTheGuiThread) {
    TaskList tasks;
    QObject receiver;
    int result = 0;
    QThread* deliveredOn = nullptr;
    Task* task = tasks.start(
        "count", &receiver, [](ProgressSink&, const std::stop_token&) { return 42; },
        [&](int value) {
            result = value;
            deliveredOn = QThread::currentThread();
        });
    waitForEnd(task);
    EXPECT_EQ(task->state(), Task::State::Done);
    EXPECT_EQ(result, 42);
    EXPECT_EQ(deliveredOn, QThread::currentThread());
}

TEST(TaskList, TellsAnErrorAsItsSentenceAndDeliversNothing) {
    TaskList tasks;
    QObject receiver;
    bool delivered = false;
    Task* task = tasks.start(
        "fail", &receiver,
        [](ProgressSink&, const std::stop_token&) { throw Error(ErrorKind::Full, "The disk is full."); },
        [&] { delivered = true; });
    waitForEnd(task);
    EXPECT_EQ(task->state(), Task::State::Failed);
    EXPECT_EQ(task->sentence(), "The disk is full.");
    EXPECT_FALSE(delivered);
}

TEST(TaskList, DeliversNothingToAReceiverThatIsGone) {
    TaskList tasks;
    auto receiver = std::make_unique<QObject>();
    bool delivered = false;
    Task* task = tasks.start(
        "late", receiver.get(), [](ProgressSink&, const std::stop_token&) {}, [&] { delivered = true; });
    receiver.reset();
    waitForEnd(task);
    EXPECT_EQ(task->state(), Task::State::Done);
    EXPECT_FALSE(delivered);
}

TEST(TaskList, StopsAJobThatIsAskedTo) {
    TaskList tasks;
    Task* task = tasks.start("long", &tasks, runUntilStopped, [] {});
    task->stop();
    waitForEnd(task);
    EXPECT_EQ(task->state(), Task::State::Stopped);
    EXPECT_TRUE(task->sentence().isEmpty());
}

TEST(TaskList, AStoppedTaskHasEndedAtOnceAndTellsItOnce) {
    TaskList tasks;
    Task* task = tasks.start("long", &tasks, runUntilStopped, [] {});
    QSignalSpy ends(task, &Task::ended);
    tasks.stopAll();
    EXPECT_EQ(task->state(), Task::State::Stopped);
    QCoreApplication::processEvents();
    EXPECT_EQ(ends.size(), 1);
}

TEST(TaskList, WaitsForAllWhenItEnds) {
    std::atomic<int> ended = 0;
    {
        TaskList tasks;
        for (int i = 0; i < 3; ++i) {
            tasks.start(
                "long", &tasks,
                [&](ProgressSink& progress, const std::stop_token& stop) {
                    try {
                        runUntilStopped(progress, stop);
                    } catch (const Error&) {
                        ++ended;
                        throw;
                    }
                },
                [] {});
        }
    }
    EXPECT_EQ(ended, 3);
}

TEST(TaskList, LooksAtProgressAtMostTwentyTimesASecond) {
    TaskList tasks;
    std::atomic<bool> goOn = true;
    Task* task = tasks.start(
        "busy", &tasks,
        [&](ProgressSink& progress, const std::stop_token& stop) {
            for (int i = 0; goOn && !stop.stop_requested(); ++i) {
                progress.progress(1 - 1 / (1.0 + i), "counting");
            }
        },
        [] {});
    QSignalSpy looks(task, &Task::progressed);
    const auto begin = std::chrono::steady_clock::now();
    while (looks.size() < 5) {
        ASSERT_TRUE(looks.wait(100'000));
    }
    const auto took = std::chrono::steady_clock::now() - begin;
    EXPECT_GE(took, 4 * 45ms); // timers may be 5 % early
    goOn = false;
    waitForEnd(task);
    EXPECT_EQ(task->step(), "counting");
}

TEST(TaskList, PassesEveryWarningOn) {
    TaskList tasks;
    Task* task = tasks.start(
        "warn", &tasks,
        [](ProgressSink& progress, const std::stop_token&) {
            progress.warning("first");
            progress.warning("second");
        },
        [] {});
    waitForEnd(task);
    EXPECT_EQ(task->warnings(), QStringList({"first", "second"}));
}

} // namespace spherewalk::ui
