// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/render/dataset_format.h"

#include <QDoubleSpinBox>
#include <QString>

namespace spherewalk::ui {

/// Return a scene model and a sampling as a translated word for the middle of a sentence.
QString sceneWord(render::SceneKind scene);
QString samplingWord(render::Sampling sampling);

/// Describes the scene model that the dataset chooses for this camera: "As measured: room", "Best there is:
/// depth". info: null without a dataset.
QString autoSceneWords(const render::DatasetInfo* info, const CameraIntrinsics& camera);
/// Describes the sampling that the dataset chooses: "As measured: bilinear", "As needed". info: null without
/// a dataset.
QString autoSamplingWords(const render::DatasetInfo* info, const CameraIntrinsics& camera);

/// A box for the tolerance of a view: 95 of 100 places are displaced by no more. Units: pixels of the robot's
/// camera.
class ToleranceBox : public QDoubleSpinBox {
    Q_OBJECT

  public:
    explicit ToleranceBox(const QString& name, QWidget* parent = nullptr);
};

} // namespace spherewalk::ui
