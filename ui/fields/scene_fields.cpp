// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/scene_fields.h"

#include <QCoreApplication>

#include <algorithm>

namespace spherewalk::ui {

namespace {

/// The words of this file, for translators.
struct RungWords {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::RungWords)
};

bool isMeasured(const render::DatasetInfo* info, const CameraIntrinsics& camera) {
    return info != nullptr && info->choice && info->choice->isFor(camera);
}

} // namespace

QString sceneWord(render::SceneKind scene) {
    switch (scene) {
    case render::SceneKind::None:
        return RungWords::tr("none");
    case render::SceneKind::Sphere:
        return RungWords::tr("sphere");
    case render::SceneKind::Room:
        return RungWords::tr("room");
    case render::SceneKind::Depth:
        return RungWords::tr("depth");
    case render::SceneKind::Blend:
        return RungWords::tr("blend");
    }
    return {};
}

QString samplingWord(render::Sampling sampling) {
    switch (sampling) {
    case render::Sampling::Nearest:
        return RungWords::tr("nearest");
    case render::Sampling::Bilinear:
        return RungWords::tr("bilinear");
    case render::Sampling::Reduced:
        return RungWords::tr("reduced");
    case render::Sampling::Footprint:
        return RungWords::tr("footprint");
    case render::Sampling::Bicubic:
        return RungWords::tr("bicubic");
    case render::Sampling::Best:
        return RungWords::tr("Best there is");
    case render::Sampling::Auto:
        return RungWords::tr("as needed");
    }
    return {};
}

QString autoSceneWords(const render::DatasetInfo* info, const CameraIntrinsics& camera) {
    if (info == nullptr) {
        return RungWords::tr("Best there is");
    }
    if (!isMeasured(info, camera)) {
        render::SceneKind best = render::SceneKind::None;
        for (std::size_t i = 0; i < info->photos.size(); ++i) {
            best = std::max(best, render::bestScene(*info, i));
        }
        return RungWords::tr("Best there is: %1").arg(sceneWord(best));
    }
    const bool isMixed =
        std::any_of(info->photos.begin(), info->photos.end(),
                    [](const render::DatasetPhoto& photo) { return photo.scene.has_value(); });
    const QString scene = sceneWord(info->choice->scene);
    return isMixed ? RungWords::tr("As measured: %1, cheaper where enough").arg(scene)
                   : RungWords::tr("As measured: %1").arg(scene);
}

QString autoSamplingWords(const render::DatasetInfo* info, const CameraIntrinsics& camera) {
    return isMeasured(info, camera)
               ? RungWords::tr("As measured: %1").arg(samplingWord(info->choice->sampling))
               : RungWords::tr("As needed");
}

ToleranceBox::ToleranceBox(const QString& name, QWidget* parent) : QDoubleSpinBox(parent) {
    setObjectName(name);
    setRange(0.1, 1000);
    setDecimals(1);
    setValue(2);
    setSuffix(tr(" px"));
    setAccessibleName(tr("Tolerance"));
    setToolTip(tr("Pixels of the robot's camera that 95 of 100 places of a view may be displaced by"));
}

} // namespace spherewalk::ui
