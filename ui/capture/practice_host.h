// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/camera/endpoint.h"
#include "spherewalk/practice/practice_camera.h"

#include <memory>

namespace spherewalk::ui {

/// How the practice camera inside of the program behaves, and how its room is planned.
struct PracticeSettings {
    int width = 2688;        ///< half of a Theta V's, so that drawing keeps nobody waiting
    double timeScale = 0.05; ///< of a Theta V's own times
    double stepM = 0.6;      ///< coarse, so that it is over in a minute
    bool keepsPhotos = true; ///< between runs of the program, so that what was interrupted can be settled
};

/// A practice camera inside of the program, over real HTTP at an address of its own. Threads: any.
class PracticeHost {
  public:
    /// Returns when the camera answers. Errors: those of practice::PracticeCamera.
    explicit PracticeHost(const PracticeSettings& settings);

    camera::Endpoint endpoint() const { return {"127.0.0.1", m_camera->port()}; }

    practice::PracticeCamera& camera() { return *m_camera; }

  private:
    std::unique_ptr<practice::PracticeCamera> m_camera;
};

} // namespace spherewalk::ui
