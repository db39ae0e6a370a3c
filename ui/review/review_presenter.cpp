// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/review_presenter.h"

#include "ui/fields/scene_fields.h"
#include "ui/frame/settings.h"
#include "ui/look/core_words.h"
#include "ui/review/finding_words.h"

#include "spherewalk/base/error.h"
#include "spherewalk/jobs/export_dataset.h"
#include "spherewalk/jobs/judge_survey.h"
#include "spherewalk/scene/room_fit.h"

#include <QFileInfo>

#include <algorithm>
#include <map>
#include <utility>

namespace spherewalk::ui {

namespace {

constexpr std::size_t kMostNeighbours = 8;

/// The nearest photos, then those of unknown place that were taken soon before or after.
std::vector<const ReviewRow*> nearest(const std::vector<ReviewRow>& rows, const ReviewRow& to) {
    std::vector<const ReviewRow*> others;
    for (const ReviewRow& row : rows) {
        if (row.photo && row.station != to.station) {
            others.push_back(&row);
        }
    }
    const auto distance = [&](const ReviewRow* row) {
        const std::optional<double> metres = apartM(*row, to);
        return std::pair(!metres, metres.value_or(std::abs(static_cast<double>(row->station - to.station))));
    };
    const auto end = others.begin() + static_cast<std::ptrdiff_t>(std::min(kMostNeighbours, others.size()));
    std::partial_sort(others.begin(), end, others.end(),
                      [&](const ReviewRow* a, const ReviewRow* b) { return distance(a) < distance(b); });
    others.erase(end, others.end());
    return others;
}

/// Returns the radius of a sphere around the middle of the stations that stands for the room.
std::optional<double> radiusOf(const survey::Room& room, const std::vector<ReviewRow>& rows) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int placed = 0;
    for (const ReviewRow& row : rows) {
        sum += row.isPlaced ? row.positionM : Eigen::Vector3d::Zero();
        placed += row.isPlaced ? 1 : 0;
    }
    return placed == 0 ? std::nullopt : scene::sphereRadius(room, {sum / placed});
}

Surroundings surroundingsOf(const survey::Room& room, const std::vector<ReviewRow>& rows) {
    Surroundings result;
    if (room.outline.size() >= 3 && room.ceilingM > 0) {
        result.room = render::RoomShape{room.outline, 0, room.ceilingM};
    }
    result.sphereRadiusM = radiusOf(room, rows);
    return result;
}

Told foundWords(const jobs::FaceReport& report) {
    const QString searched =
        ReviewPresenter::tr("%n photo(s) searched", nullptr, static_cast<int>(report.photos));
    if (report.regions == 0) {
        return ReviewPresenter::tr("%1: no face found.").arg(searched);
    }
    return {
        ReviewPresenter::tr("%1: %2 %3, which exports show blurred.")
            .arg(searched, ReviewPresenter::tr("%n face(s) found", nullptr, static_cast<int>(report.regions)),
                 ReviewPresenter::tr("in %n photo(s)", nullptr, static_cast<int>(report.photosWithRegions))),
        Cure::Regions};
}

} // namespace

SurveyWatch::SurveyWatch(QObject* parent) : QObject(parent) {
    m_timer.setInterval(std::chrono::seconds(1));
    connect(&m_timer, &QTimer::timeout, this, [this] { look(false); });
}

void SurveyWatch::setSession(SurveySession* session) {
    if (m_session) {
        m_session->disconnect(this);
    }
    m_session = session;
    m_timer.stop();
    m_store.reset();
    if (session != nullptr) {
        m_store = std::make_shared<const store::SurveyStore>(
            store::SurveyStore::open(session->path(), store::Access::Read));
        m_seen = m_store->dataVersion();
        // What the session itself says is known, whoever wrote it.
        connect(session, &SurveySession::changed, this, [this] {
            ++m_told;
            look(true);
        });
        m_timer.start();
    }
}

void SurveyWatch::look(bool isKnown) {
    m_worker.post(isKnown ? "known" : "look",
                  [this, store = m_store, isKnown, told = m_told]() -> BackgroundWorker::Deliver {
                      try {
                          return [this, store, isKnown, told, version = store->dataVersion()] {
                              if (store != m_store) {
                                  return; // another survey is open meanwhile
                              }
                              const bool isNews = version != std::exchange(m_seen, version);
                              if (isNews && !isKnown && told == m_told && m_session) {
                                  m_session->noteChangedSoon(SurveySession::Everything);
                              }
                          };
                      } catch (const Error&) { // busy for a moment; it looks again
                          return {};
                      }
                  });
}

ReviewPresenter::ReviewPresenter(TaskList& tasks, std::filesystem::path thumbnailFolder,
                                 PanoramaPresenter& viewer, QObject* parent)
    : SurveyPresenter(parent),
      m_tasks(tasks),
      m_viewer(viewer),
      m_thumbnails(std::move(thumbnailFolder)),
      m_model(m_thumbnails),
      m_list(m_model) {
    connect(&m_reviewer, &PhotoReviewer::refused, this, &ReviewPresenter::message);
}

void ReviewPresenter::setSession(SurveySession* session) {
    m_reviewer.setSession(session);
    m_watch.setSession(session);
    m_thumbnails.forgetRequests();
    m_errors.reset();
    m_errorsFile.clear();
    m_depths.clear();
    SurveyPresenter::setSession(session);
    if (session != nullptr) {
        connect(session, &SurveySession::readOnlyChanged, this, &ReviewPresenter::currentChanged);
        connect(session->selection(), &StationSelection::currentChanged, this, &ReviewPresenter::showCurrent);
    }
}

void ReviewPresenter::read() {
    try {
        std::vector<ReviewRow> rows =
            session() != nullptr ? reviewRows(session()->store(), jobs::activeFindings(session()->store()))
                                 : std::vector<ReviewRow>();
        if (m_errors) {
            fillErrors(rows, *m_errors);
        }
        m_model.setRows(std::move(rows));
        m_unsearched =
            session() != nullptr ? static_cast<int>(jobs::unsearchedPhotos(session()->store())) : 0;
        m_viewer.setSurroundings(
            session() != nullptr ? surroundingsOf(session()->state().room, m_model.rows()) : Surroundings());
    } catch (const Error& error) {
        emit message(coreTold(error.sentence()));
    }
    m_list.invalidate();
    if (m_compared) {
        lookForDepths(); // with other poses, others hold
    }
    showCurrent();
    emit rowsChanged();
}

QString ReviewPresenter::surveyId() const {
    return session() != nullptr ? QString::fromStdString(session()->store().info().uuid) : QString();
}

/// Reads a report. Errors: those of jobs::readMeasuredPhotos(); InvalidInput for another survey.
void ReviewPresenter::takeErrors(const QString& reportFile) {
    m_errorsFile = QFileInfo(reportFile).absoluteFilePath(); // first: what cannot be read is told once
    m_errorsSince = QFileInfo(reportFile).lastModified();
    jobs::MeasuredPhotos errors = jobs::readMeasuredPhotos(reportFile.toStdString());
    if (QString::fromStdString(errors.surveyId) != surveyId()) {
        throw Error(ErrorKind::InvalidInput, tr("The report %1 is of another survey's dataset, %2.")
                                                 .arg(reportFile, QString::fromStdString(errors.dataset))
                                                 .toStdString());
    }
    m_errors = std::move(errors);
    read();
}

void ReviewPresenter::readErrors(const QString& reportFile) {
    try {
        takeErrors(reportFile);
        Settings().setMeasuredReport(surveyId(), reportFile);
    } catch (const Error& error) {
        emit message(coreTold(error.sentence()));
    }
}

void ReviewPresenter::lookForErrors() {
    const QString file = session() != nullptr ? Settings().measuredReport(surveyId()) : QString();
    if (!file.isEmpty() && (file != m_errorsFile || QFileInfo(file).lastModified() != m_errorsSince)) {
        readErrors(file);
    }
}

QString ReviewPresenter::errorWords() const {
    if (!m_errors) {
        return tr(
            "No dataset of this survey has been measured yet: do so in Export, or choose the report.json "
            "of one that was.");
    }
    return tr("Displacement of 95 of 100 places, where the photo was left out of %1; scene model %2, "
              "tolerance "
              "%L3 px.")
        .arg(QString::fromStdString(m_errors->dataset), sceneWord(m_errors->scene))
        .arg(m_errors->tolerancePx, 0, 'f', 1);
}

const ReviewRow* ReviewPresenter::current() const {
    const auto station = session() != nullptr ? session()->selection()->current() : std::nullopt;
    return station ? m_model.rowOf(*station) : nullptr;
}

void ReviewPresenter::setCurrent(std::optional<std::int64_t> station) {
    if (session() != nullptr) {
        session()->selection()->setCurrent(station);
    }
}

void ReviewPresenter::step(int by) {
    const ReviewRow* row = current();
    const QModelIndex here = row != nullptr ? m_list.indexOf(row->station) : QModelIndex();
    for (int i = here.isValid() ? here.row() + by : 0; i >= 0 && i < m_list.rowCount(); i += by) {
        const std::int64_t station = m_list.index(i, 0).data(ReviewModel::StationRole).toLongLong();
        if (m_model.rowOf(station)->photo) {
            return setCurrent(station);
        }
    }
}

void ReviewPresenter::decide(store::Decision decision) {
    const ReviewRow* row = current();
    if (row == nullptr || !row->photo) {
        return;
    }
    const std::int64_t photo = *row->photo;
    if (decision != store::Decision::Open) {
        step(1); // before: a decided photo may leave the list
    }
    m_reviewer.decide({photo}, decision);
}

void ReviewPresenter::decideAll(const std::vector<std::int64_t>& stations, store::Decision decision) {
    std::vector<std::int64_t> photos;
    for (const std::int64_t station : stations) {
        const ReviewRow* row = m_model.rowOf(station);
        if (row != nullptr && row->photo) {
            photos.push_back(*row->photo);
        }
    }
    if (!photos.empty()) {
        m_reviewer.decide(photos, decision);
    }
}

std::vector<std::int64_t> ReviewPresenter::goodStations() const {
    std::vector<std::int64_t> result;
    for (const ReviewRow& row : m_model.rows()) {
        if (row.isChecked && row.standing == Standing::Taken) {
            result.push_back(row.station);
        }
    }
    return result;
}

int ReviewPresenter::unchecked() const {
    return static_cast<int>(std::count_if(m_model.rows().begin(), m_model.rows().end(),
                                          [](const ReviewRow& row) { return row.photo && !row.isChecked; }));
}

void ReviewPresenter::check() {
    if (!canDecide() || (m_checking && m_checking->isRunning())) {
        return;
    }
    m_checking = m_tasks.start(
        tr("Checking photos"), this,
        [folder = session()->path()](ProgressSink& progress, const std::stop_token& stop) {
            auto store = store::SurveyStore::open(folder, store::Access::Write);
            return jobs::judgeSurvey(store, false, progress, stop);
        },
        [this](const jobs::JudgeReport& report) {
            emit message(tr("%n photo(s) checked: %1 good, %2 doubtful, %3 failed.", nullptr, report.judged)
                             .arg(report.good)
                             .arg(report.doubtful)
                             .arg(report.failed));
        });
    connect(m_checking, &Task::ended, this, [this] {
        if (session() != nullptr) {
            session()->noteChanged(SurveySession::Photos);
        }
    });
}

void ReviewPresenter::setNote(std::int64_t photo, const QString& note) {
    m_reviewer.setNote(photo, note);
}

void ReviewPresenter::compareWith(std::optional<std::size_t> neighbour) {
    if (neighbour && !m_compared) {
        lookForDepths();
    }
    m_compared = neighbour;
    showCurrent();
}

bool ReviewPresenter::canDecide() const {
    return session() != nullptr && !session()->isReadOnly() && searching() == nullptr &&
           !(m_checking && m_checking->isRunning());
}

void ReviewPresenter::markRegion(const survey::PrivateRegion& region) {
    const ReviewRow* row = current();
    if (row != nullptr && row->photo) {
        if (const auto marked = m_reviewer.markRegion(*row->photo, region)) {
            m_viewer.regions().select(marked);
        }
    }
}

void ReviewPresenter::removeRegion() {
    const ReviewRow* row = current();
    const ShownRegion* selected = m_viewer.regions().selected();
    if (row == nullptr || selected == nullptr) {
        return;
    }
    const auto region = std::find_if(row->regions.begin(), row->regions.end(),
                                     [&](const store::RegionRecord& one) { return one.id == selected->id; });
    if (region != row->regions.end()) {
        m_reviewer.removeRegion(store::RegionRecord(*region)); // a copy: the row is read anew meanwhile
    }
}

bool ReviewPresenter::canSearchFaces() const {
    return canDecide() && std::any_of(m_model.rows().begin(), m_model.rows().end(),
                                      [](const ReviewRow& row) { return row.photo.has_value(); });
}

void ReviewPresenter::searchFaces() {
    if (!canSearchFaces()) {
        return;
    }
    jobs::FaceOptions options;
    options.again = m_unsearched == 0;
    m_searching = m_tasks.start(
        tr("Searching for faces"), this,
        [folder = session()->path(), options](ProgressSink& progress, const std::stop_token& stop) {
            auto store = store::SurveyStore::open(folder, store::Access::Write);
            return jobs::searchFaces(store, options, progress, stop);
        },
        [this](const jobs::FaceReport& report) { emit message(foundWords(report)); });
    connect(m_searching, &Task::ended, this, [this] {
        if (session() != nullptr) {
            session()->noteChanged(SurveySession::Photos);
        }
        emit searchChanged();
    });
    emit searchChanged();
    emit currentChanged(); // decisions have to wait
}

/// Looks for the depths that exports have kept, with which a neighbour is moved best.
void ReviewPresenter::lookForDepths() {
    if (session() == nullptr) {
        return;
    }
    const std::filesystem::path folder = session()->path();
    m_worker.post("depths", [this, folder]() -> BackgroundWorker::Deliver {
        try {
            const auto store = store::SurveyStore::open(folder, store::Access::Read);
            return [this, folder, depths = jobs::keptDepths(store, {}, {})] {
                if (session() != nullptr && session()->path() == folder) {
                    m_depths = depths;
                    showCurrent();
                }
            };
        } catch (const Error&) { // the drawn room is then enough
            return {};
        }
    });
}

ShownPhoto ReviewPresenter::shown(const ReviewRow& row) const {
    ShownPhoto photo = row.shown();
    if (const auto depth = m_depths.find(*row.photo); depth != m_depths.end()) {
        photo.depthFile = depth->second;
    }
    return photo;
}

void ReviewPresenter::showCurrent() {
    const ReviewRow* row = current();
    m_neighbours = row != nullptr ? nearest(m_model.rows(), *row) : std::vector<const ReviewRow*>();
    m_viewer.show(row != nullptr && row->photo ? std::optional(shown(*row)) : std::nullopt);
    const bool isCompared = m_compared && *m_compared < m_neighbours.size();
    m_viewer.setOther(isCompared ? std::optional(shown(*m_neighbours[*m_compared])) : std::nullopt);
    emit currentChanged();
}

QString ReviewPresenter::summary() const {
    std::map<Standing, int> counts;
    int open = 0;
    for (const ReviewRow& row : m_model.rows()) {
        ++counts[row.standing];
        open += passes(ReviewFilter::ToReview, row) ? 1 : 0;
    }
    return tr("%1 accepted, %2 rejected, %3 to be reviewed, %4 missing")
        .arg(counts[Standing::Accepted])
        .arg(counts[Standing::Rejected])
        .arg(open)
        .arg(counts[Standing::Missing]);
}

} // namespace spherewalk::ui
