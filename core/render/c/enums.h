// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "spherewalk/base/error.h"
#include "spherewalk/render/view_stream.h"
#include "spherewalk/spherewalk.h"

#include <optional>

/// The numbers of the C interface for the enumerations of the C++ one, and back. Functions that take a number
/// throw InvalidInput for one without a meaning.
namespace spherewalk::render {

spherewalk_status cStatus(ErrorKind kind);

/// The kind of error of a status. It is nothing for a status that is no error.
std::optional<ErrorKind> errorKindOf(spherewalk_status status);

Verify verifyOf(std::int32_t number);
VerifyPhotos verifyPhotosOf(std::int32_t number);

LensModel lensOf(std::int32_t number);
std::int32_t cLens(LensModel lens);

/// The scene model. It is nothing for SPHEREWALK_SCENE_BEST.
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
