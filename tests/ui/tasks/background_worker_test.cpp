// SPDX-License-Identifier: GPL-3.0-or-later
#include "qt_application.h"
#include "ui/tasks/background_worker.h"

#include <QTest>

#include <future>

namespace spherewalk::ui {

namespace {

/// Keeps the worker busy until it is released, so that what is posted meanwhile waits.
class Held {
  public:
    explicit Held(BackgroundWorker& worker) {
        worker.post("held", [this]() -> BackgroundWorker::Deliver {
            m_begun.set_value();
            m_released.get_future().wait();
            return nullptr;
        });
        m_begun.get_future().wait();
    }

    void release() { m_released.set_value(); }

  private:
    std::promise<void> m_begun;
    std::promise<void> m_released;
};

BackgroundWorker::Work adding(const QString& word, QStringList& to) {
    return [word, &to]() -> BackgroundWorker::Deliver { return [word, &to] { to << word; }; };
}

} // namespace

TEST(BackgroundWorker, DoesWhatWasAskedForLastFirst) {
    QStringList done;
    BackgroundWorker worker;
    Held held(worker);
    worker.post("a", adding("a", done));
    worker.post("b", adding("b", done));
    held.release();
    ASSERT_TRUE(QTest::qWaitFor([&] { return done.size() == 2; }));
    EXPECT_EQ(done, (QStringList{"b", "a"}));
}

TEST(BackgroundWorker, ReplacesWhatWaitsUnderTheSameKey) {
    QStringList done;
    BackgroundWorker worker;
    Held held(worker);
    worker.post("view", adding("old", done));
    worker.post("other", adding("other", done));
    worker.post("view", adding("new", done));
    held.release();
    ASSERT_TRUE(QTest::qWaitFor([&] { return done.contains("other"); }));
    EXPECT_EQ(done, (QStringList{"new", "other"}));
}

TEST(BackgroundWorker, DoesNextWhatIsHurried) {
    QStringList done;
    BackgroundWorker worker;
    Held held(worker);
    worker.post("a", adding("a", done));
    worker.post("b", adding("b", done));
    worker.hurry("a");
    worker.hurry("unknown");
    held.release();
    ASSERT_TRUE(QTest::qWaitFor([&] { return done.size() == 2; }));
    EXPECT_EQ(done, (QStringList{"a", "b"}));
}

TEST(BackgroundWorker, DropsWhatWaits) {
    QStringList done;
    BackgroundWorker worker;
    Held held(worker);
    worker.post("a", adding("a", done));
    worker.dropWaiting();
    worker.post("b", adding("b", done));
    held.release();
    ASSERT_TRUE(QTest::qWaitFor([&] { return done.contains("b"); }));
    EXPECT_EQ(done, QStringList{"b"});
}

TEST(BackgroundWorker, DeliversNothingOnceItIsGone) {
    QStringList done;
    std::promise<void> made;
    {
        BackgroundWorker worker;
        worker.post("a", [&]() -> BackgroundWorker::Deliver {
            made.set_value();
            return [&] { done << "a"; };
        });
        made.get_future().wait();
    }
    QCoreApplication::processEvents();
    EXPECT_TRUE(done.isEmpty());
}

} // namespace spherewalk::ui
