// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "temporary_folder.h"

#include <QApplication>
#include <QTest>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

namespace spherewalk::test {

/// The one application of a test program, without a display unless QT_QPA_PLATFORM says otherwise. It ends
/// with the tests, as Qt does not outlive main().
class QtApplication : public testing::Environment {
  public:
    void SetUp() override {
        if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM")) {
            qputenv("QT_QPA_PLATFORM", "offscreen");
        }
        // Settings, caches and documents of the tests are not those of the person who runs them.
        for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"}) {
            qputenv(place, m_home.path().c_str());
        }
        QApplication::setOrganizationName("spherewalk-test");
        m_application = std::make_unique<QApplication>(m_argc, m_argv);
    }

    void TearDown() override { m_application.reset(); }

  private:
    TemporaryFolder m_home;
    int m_argc = 1;
    char m_name[5] = "test";
    char* m_argv[2] = {m_name, nullptr};
    std::unique_ptr<QApplication> m_application;
};

/// Owner: GoogleTest.
inline testing::Environment* const qtApplication = testing::AddGlobalTestEnvironment(new QtApplication);

/// Gives a window the keyboard, as a person who clicks it.
inline void activate(QWidget& window) {
    window.activateWindow();
    if (!QTest::qWaitForWindowActive(&window)) {
        throw std::runtime_error("the window did not become active");
    }
}

} // namespace spherewalk::test
