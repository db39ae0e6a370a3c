// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "c_view.h"

#include "spherewalk/render/view_stream.h"

#include <memory>
#include <mutex>

/// What the handles of the C interface are.

struct spherewalk_dataset {
    std::shared_ptr<const spherewalk::render::Dataset> dataset;
    bool isVerified; ///< all hashes
};

struct spherewalk_camera {
    spherewalk::CameraModel model;
};

struct spherewalk_renderer {
    spherewalk::render::Renderer renderer;
    mutable std::mutex inUse{}; ///< of spare
    mutable spherewalk::render::ViewMemory spare{};
};

struct spherewalk_stream {
    spherewalk::render::ViewStream stream;
    spherewalk::CameraIntrinsics camera;
    std::mutex inUse{};
    spherewalk::render::ViewMemory spare{};
};
