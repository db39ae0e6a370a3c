// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/error.h"
#include "spherewalk/render/view_stream.h"
#include "spherewalk/spherewalk.h"

#include <optional>

/// The numbers of the C interface and the enumerations of the C++ one. Errors of those that take a number:
/// InvalidInput for one that means nothing.
namespace spherewalk::render {

spherewalk_status cStatus(ErrorKind kind);
/// Nothing for what is no status of an error.
std::optional<ErrorKind> errorKindOf(spherewalk_status status);

Verify verifyOf(std::int32_t number);
VerifyPhotos verifyPhotosOf(std::int32_t number);

LensModel lensOf(std::int32_t number);
std::int32_t cLens(LensModel lens);

/// Nothing for SPHEREWALK_SCENE_BEST.
std::optional<SceneKind> sceneOf(std::int32_t number);
std::int32_t cScene(SceneKind scene);

Sampling samplingOf(std::int32_t number);
std::int32_t cSampling(Sampling sampling);

ViewOrigin originOf(std::int32_t number);
std::int32_t cOrigin(ViewOrigin origin);

Alpha alphaOf(std::int32_t number);
Edges edgesOf(std::int32_t number);

LatePolicy lateOf(std::int32_t number);
std::int32_t cLate(LatePolicy policy);

} // namespace spherewalk::render
