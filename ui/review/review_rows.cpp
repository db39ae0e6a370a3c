// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_rows.h"

#include "ui/plan/station_words.h"

#include "spherewalk/jobs/judge_survey.h"

#include <map>

namespace spherewalk::ui {

namespace {

/// found: of the checks of the picture. status: of the alignment.
Standing standingOf(store::Decision decision, store::CheckResult found, const std::string& status) {
    switch (decision) {
    case store::Decision::Accepted:
        return Standing::Accepted;
    case store::Decision::Rejected:
        return Standing::Rejected;
    case store::Decision::Open:
        break;
    }
    const bool isFailed = found == store::CheckResult::Failed || status == "failed";
    const bool isDoubtful = found == store::CheckResult::Doubtful || status == "doubtful";
    return isFailed ? Standing::Failed : isDoubtful ? Standing::Doubtful : Standing::Taken;
}

void fill(ReviewRow& row, const store::PhotoRecord& photo, const std::filesystem::path& folder) {
    row.photo = photo.id;
    row.file = folder / photo.fileName;
    row.fileName = QString::fromStdString(photo.fileName);
    row.sha256 = QString::fromStdString(photo.fileSha256);
}

void fill(ReviewRow& row, const store::PhotoVerdict& verdict) {
    for (const photo::Finding& finding : jobs::verdictOf(verdict).findings) {
        row.flags << QString::fromStdString(finding.sentence);
    }
}

void fill(ReviewRow& row, const jobs::PhotoFinding& finding) {
    row.roomFromPhoto = finding.roomFromPhoto;
    row.sigmaYaw = finding.sigmaYaw;
    row.residual = finding.residual;
    for (const std::string& flag : finding.flags) {
        row.flags << QString::fromStdString(flag);
    }
}

} // namespace

ShownPhoto ReviewRow::shown() const {
    return {file, QObject::tr("%1 (%2)").arg(stationName, fileName),
            roomFromPhoto.value_or(Rigid3{Eigen::Quaterniond::Identity(), positionM})};
}

std::vector<ReviewRow> reviewRows(const store::SurveyStore& store,
                                  const std::optional<jobs::SolutionFindings>& findings) {
    std::map<std::int64_t, store::PhotoRecord> photos; // by station
    for (store::PhotoRecord& photo : store.chosenPhotos()) {
        const std::int64_t station = photo.station;
        photos.emplace(station, std::move(photo));
    }
    std::map<std::int64_t, store::Review> reviews; // by photo
    for (store::Review& review : store.reviews()) {
        const std::int64_t photo = review.photo;
        reviews.emplace(photo, std::move(review));
    }
    std::map<std::int64_t, store::PhotoVerdict> verdicts; // by photo
    for (store::PhotoVerdict& verdict : store.verdicts()) {
        const std::int64_t photo = verdict.photo;
        verdicts.emplace(photo, std::move(verdict));
    }
    std::map<std::int64_t, const jobs::PhotoFinding*> found; // by photo
    if (findings) {
        for (const jobs::PhotoFinding& finding : findings->photos) {
            found.emplace(finding.photo, &finding);
        }
    }
    std::vector<ReviewRow> rows;
    for (const store::StationRecord& station : store.stations()) {
        ReviewRow row;
        row.station = station.id;
        row.stationName = stationWords(station.name);
        row.positionM = station.station.positionM;
        if (const auto photo = photos.find(station.id); photo != photos.end()) {
            fill(row, photo->second, store.photoFolder());
            if (const auto review = reviews.find(*row.photo); review != reviews.end()) {
                row.decision = review->second.decision;
                row.note = QString::fromStdString(review->second.note);
            }
            const auto verdict = verdicts.find(*row.photo);
            if (verdict != verdicts.end()) {
                fill(row, verdict->second);
            }
            const auto finding = found.find(*row.photo);
            if (finding != found.end()) {
                fill(row, *finding->second);
            }
            row.standing = standingOf(
                row.decision, verdict != verdicts.end() ? verdict->second.result : store::CheckResult::Good,
                finding != found.end() ? finding->second->status : std::string());
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

void fillErrors(std::vector<ReviewRow>& rows, const jobs::MeasuredPhotos& measured) {
    std::map<std::filesystem::path, std::optional<double>> errorsPx; // by the file's name without its ending
    for (const jobs::MeasuredPhoto& photo : measured.photos) {
        errorsPx.emplace(std::filesystem::path(photo.file).stem(), photo.p95Px);
    }
    for (ReviewRow& row : rows) {
        const auto found = errorsPx.find(row.file.stem());
        if (row.photo && found != errorsPx.end()) {
            row.errorPx = found->second;
        }
    }
}

} // namespace spherewalk::ui
