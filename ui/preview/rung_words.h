// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/dataset_format.h"

#include <QString>

namespace spherewalk::ui {

/// Scene models and samplings in a word, translated, as they stand in a sentence.
QString sceneWord(render::SceneKind scene);
QString samplingWord(render::Sampling sampling);

/// What leaving the scene model to the dataset means for this camera: "As measured: room", "Best there is:
/// depth". info: null without a dataset.
QString autoSceneWords(const render::DatasetInfo* info, const CameraIntrinsics& camera);
/// The same of the sampling: "As measured: bilinear", "As needed".
QString autoSamplingWords(const render::DatasetInfo* info, const CameraIntrinsics& camera);

} // namespace spherewalk::ui
