// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/grid_study_presenter.h"

#include "spherewalk/jobs/measure_survey.h"

namespace spherewalk::ui {

namespace {

constexpr double kExportShare = 0.1; ///< of the time, about

/// On the task's thread.
jobs::GridStudy studied(const std::filesystem::path& survey, const GridQuestion& question,
                        ProgressSink& progress, const std::stop_token& stop) {
    const auto store = store::SurveyStore::open(survey, store::Access::Read);
    const std::filesystem::path cache = jobs::measureCacheFolder(survey);
    ProgressStep exporting(progress, 0, kExportShare);
    // The study finds depths of its own, from the photos that it keeps.
    const auto folder = jobs::surveyDataset(store, render::SceneKind::Sphere, cache, exporting, stop);
    const render::Renderer renderer(
        std::make_shared<const render::Dataset>(render::Dataset::open(folder, render::Verify::Sizes)));
    jobs::GridStudyOptions options;
    options.tolerancePx = question.tolerancePx;
    options.withDepth = question.withDepth;
    options.room = store.room();
    options.plan = store.planOptions();
    options.cacheFolder = cache / "results";
    ProgressStep studying(progress, kExportShare, 1);
    return jobs::gridStudy(renderer, CameraModel(question.camera), options, studying, stop);
}

} // namespace

GridStudyPresenter::GridStudyPresenter(TaskList& tasks, QObject* parent)
    : SurveyPresenter(parent), m_tasks(tasks) {
}

void GridStudyPresenter::setSession(SurveySession* session) {
    m_problem.clear();
    SurveyPresenter::setSession(session);
}

QString GridStudyPresenter::obstacle() const {
    if (session() == nullptr) {
        return tr("Open a survey with a small block of photos, 5 x 5 at the finest step that you would use.");
    }
    const int photos = session()->state().counts.stationsWithPhoto;
    if (photos < kLeastPhotos) {
        return tr("This survey has %n photo(s). Take a block of 5 x 5 at the finest step that you would use "
                  "(3 x 3 at least), and ask then.",
                  nullptr, photos);
    }
    return {};
}

void GridStudyPresenter::study(const GridQuestion& question) {
    if (task() != nullptr || !obstacle().isEmpty()) {
        return;
    }
    m_problem.clear();
    m_task = m_tasks.start(
        tr("Studying the grid of %1").arg(session()->name()), this,
        [survey = session()->path(), question](ProgressSink& progress, const std::stop_token& stop) {
            return studied(survey, question, progress, stop);
        },
        [this, name = session()->name()](jobs::GridStudy found) {
            m_found = std::move(found);
            m_foundIn = name;
            emit foundChanged();
        });
    connect(m_task, &Task::ended, this, [this, task = m_task.data()] { ended(*task); });
    emit changed();
}

void GridStudyPresenter::ended(const Task& task) {
    if (task.state() == Task::State::Failed) {
        m_problem = task.sentence();
    } else if (task.state() == Task::State::Stopped) {
        m_problem = tr("Stopped. What was found is kept: the next study goes on from there.");
    }
    emit changed();
}

QString GridStudyPresenter::words() const {
    if (!m_problem.isEmpty()) {
        return m_problem;
    }
    if (!m_found) {
        return {};
    }
    return tr("%1\nFound in %2: %n photo(s), %L3 cm apart.", nullptr, static_cast<int>(m_found->photos))
        .arg(QString::fromStdString(m_found->reason), m_foundIn)
        .arg(100 * m_found->gridStepM, 0, 'f', 0);
}

} // namespace spherewalk::ui
