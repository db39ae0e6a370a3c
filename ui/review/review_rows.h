// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/standing.h"
#include "ui/panorama/panorama_presenter.h"

#include "spherewalk/jobs/measured_photos.h"
#include "spherewalk/jobs/solution_findings.h"
#include "spherewalk/store/survey_store.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// A station with its chosen photo, as the reviewer sees it.
struct ReviewRow {
    std::int64_t station = 0;
    QString stationName;                                 ///< in the user's language
    Eigen::Vector3d positionM = Eigen::Vector3d::Zero(); ///< of the station
    Standing standing = Standing::Missing;

    // Of the chosen photo, if there is one.
    std::optional<std::int64_t> photo;
    std::filesystem::path file;
    QString fileName;
    QString sha256;
    store::Decision decision = store::Decision::Open;
    QString note;
    QStringList flags; ///< sentences of the checks and of the alignment
    std::optional<Rigid3> roomFromPhoto;
    std::optional<Radians> sigmaYaw;
    std::optional<Radians> residual;
    std::optional<double> errorPx; ///< of views in its place, as it was measured

    /// As the viewer needs it; unturned if it is not aligned. Range: a row with a photo.
    ShownPhoto shown() const;
};

/// One row a station, in walking order. findings: of the active solution, if there is one. Errors: those of
/// the store.
std::vector<ReviewRow> reviewRows(const store::SurveyStore& store,
                                  const std::optional<jobs::SolutionFindings>& findings);

/// Gives rows the errors of photos that the dataset took from their files. Photos that were taken or moved
/// since have none.
void fillErrors(std::vector<ReviewRow>& rows, const jobs::MeasuredPhotos& measured);

} // namespace spherewalk::ui
