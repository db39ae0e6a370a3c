// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_storage.h"

#include "ui/look/core_words.h"
#include "ui/look/side_panel.h"

#include "spherewalk/base/error.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace spherewalk::ui {

namespace {

constexpr auto kPlaceKey = "surveysPlace";

/// Where photos by hand stand, as far as that is known.
std::vector<survey::Station> knownPlaces(const SurveyState& survey) {
    std::vector<survey::Station> places;
    for (const store::StationRecord& station : survey.stations) {
        if (survey.isByHand() && station.isPlaceKnown) {
            places.push_back(station.station);
        }
    }
    return places;
}

/// A room to begin with where nobody knows it: a rectangle around the photos.
survey::Room roomAround(const std::vector<survey::Station>& photos) {
    constexpr double kAroundM = 1;
    survey::Room room = survey::unknownRoom();
    Polygon places;
    for (const survey::Station& photo : photos) {
        places.emplace_back(photo.positionM.head<2>());
    }
    if (!places.empty()) {
        const Bounds2 around = bounds(places);
        const Eigen::Vector2d a = around.least.array() - kAroundM;
        const Eigen::Vector2d b = around.greatest.array() + kAroundM;
        room.outline = {a, {b.x(), a.y()}, b, {a.x(), b.y()}};
    }
    return room;
}

} // namespace

PlanStorage::PlanStorage(PlanEditor& editor, QObject* parent) : QObject(parent), m_editor(editor) {
    m_calm.setSingleShot(true);
    m_calm.setInterval(kCalm);
    connect(&m_calm, &QTimer::timeout, this, &PlanStorage::flush);
    connect(&m_editor, &PlanEditor::draftChanged, this, [this] {
        if (m_session && !m_isReading && m_state != State::Locked) {
            setState(State::Edited);
        }
    });
    connect(&m_editor, &PlanEditor::outcomeChanged, this, [this] {
        if (m_state == State::Edited && m_editor.isSettled() && m_editor.outcome().problem.isEmpty()) {
            m_calm.start();
        }
    });
}

void PlanStorage::setState(State state) {
    if (state != m_state) {
        m_state = state;
        emit stateChanged();
    }
}

void PlanStorage::setSession(SurveySession* session) {
    flush();
    if (m_session) {
        m_session->disconnect(this);
    }
    m_session = session;
    if (session == nullptr) {
        return beginNew();
    }
    connect(session, &SurveySession::changed, this, [this](SurveySession::Changes what) {
        if (!m_isWriting && (what & (SurveySession::Plan | SurveySession::Photos))) {
            read(false);
        }
    });
    read(true);
}

/// Whether nobody may change the plan. The room of photos by hand may be drawn once one of them stands in it.
bool PlanStorage::isLocked(const SurveyState& survey) const {
    const store::Counts& counts = survey.counts;
    const bool isInUse = counts.photos + counts.openShots + counts.unclearShots > 0;
    return m_session->isReadOnly() || (isInUse && knownPlaces(survey).empty());
}

void PlanStorage::read(bool isOther) {
    const SurveyState& survey = m_session->state();
    const State state = isLocked(survey) ? State::Locked : State::Stored;
    PlanDraft draft{survey.room, survey.options,
                    survey.plan.isByHand ? survey.plan.placements : std::vector<survey::RailPlacement>(),
                    false, !survey.isByHand()};
    draft.byHand = knownPlaces(survey);
    if (survey.room.outline.empty()) {
        draft.room = roomAround(draft.byHand);
        draft.isRoomKnown = draft.hasRails; // Else nobody has planned it.
    }
    const PlanDraft& shown = m_editor.draft();
    const bool isSameRoom = shown.room.outline == draft.room.outline &&
                            shown.room.obstacles == draft.room.obstacles &&
                            shown.room.ceilingM == draft.room.ceilingM;
    const bool isSamePlaces = std::ranges::equal(shown.byHand, draft.byHand, {}, &survey::Station::positionM,
                                                 &survey::Station::positionM);
    const bool keepsShown = !isOther && (state == State::Locked || survey.isByHand());
    if (keepsShown && m_state == state && isSameRoom && isSamePlaces) {
        return; // edits can be undone as before
    }
    m_isReading = true;
    m_editor.setLocked(state == State::Locked);
    m_editor.begin(std::move(draft));
    m_isReading = false;
    setState(state);
}

void PlanStorage::beginNew() {
    m_editor.setLocked(false);
    setState(State::New);
    m_editor.begin(firstDraft());
}

void PlanStorage::create(const QString& folder) {
    const PlanOutcome outcome = m_editor.isSettled() ? m_editor.outcome() : outcomeOf(m_editor.draft());
    if (!outcome.problem.isEmpty()) {
        throw Error(ErrorKind::InvalidInput, outcome.problem.toStdString());
    }
    const PlanDraft& draft = m_editor.draft();
    const QString name = QFileInfo(folder).completeBaseName();
    store::SurveyStore::create(folder.toStdString(), name.toStdString(), draft.room, draft.options,
                               outcome.plan);
    emit created(folder);
}

void PlanStorage::flush() {
    m_calm.stop();
    if (!m_session || m_state != State::Edited) {
        return;
    }
    const PlanOutcome outcome = m_editor.isSettled() ? m_editor.outcome() : outcomeOf(m_editor.draft());
    if (!outcome.problem.isEmpty()) {
        return emit problem(tr("The plan is not stored: %1").arg(outcome.problem));
    }
    const PlanDraft& draft = m_editor.draft();
    m_isWriting = true;
    try {
        m_session->write(SurveySession::Plan, [&](store::SurveyStore& store) {
            if (draft.hasRails) {
                store.replacePlan(draft.room, draft.options, outcome.plan);
            } else if (draft.isRoomKnown) {
                store.replaceRoom(draft.room, store::RoomOrigin::Drawn);
            } else { // Its first edit was undone.
                store.replaceRoom(survey::unknownRoom(), store::RoomOrigin::Solved);
            }
        });
        setState(State::Stored);
    } catch (const Error& error) {
        emit problem(coreTold(error.sentence()));
    }
    m_isWriting = false;
}

QString surveysPlace() {
    const QString own = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) + "/Spherewalk";
    QString place = QSettings().value(kPlaceKey, own).toString();
    if (!QDir().mkpath(place)) {
        place = QDir::homePath();
    }
    return place;
}

NewSurveyForm::NewSurveyForm(QWidget* parent)
    : Section(tr("New survey"), parent),
      m_name(new QLineEdit(this)),
      m_place(new QPushButton(this)),
      m_create(new QPushButton(tr("&Create survey"), this)) {
    m_name->setObjectName("surveyName");
    m_create->setObjectName("createSurvey");
    makePrimary(m_create);
    QFormLayout* form = addForm();
    addRow(form, tr("&Name"), m_name, tr("What the room is called; the survey's folder gets this name."));
    addRow(form, tr("Kept &in"), m_place, tr("The folder in which the survey's folder is made."));
    layout()->addWidget(m_create);
    connect(m_place, &QPushButton::clicked, this, &NewSurveyForm::choosePlace);
    connect(m_name, &QLineEdit::textChanged, this, &NewSurveyForm::showState);
    const auto create = [this] {
        if (m_create->isEnabled()) {
            emit createRequested(folder());
        }
    };
    connect(m_name, &QLineEdit::returnPressed, this, create);
    connect(m_create, &QPushButton::clicked, this, create);
}

void NewSurveyForm::propose() {
    m_placeFolder = surveysPlace();
    for (int number = 1;; ++number) {
        m_name->setText(number == 1 ? tr("room") : tr("room %1").arg(number));
        if (!QFileInfo::exists(folder())) {
            break;
        }
    }
    showState();
}

QString NewSurveyForm::folder() const {
    return m_placeFolder + "/" + m_name->text().trimmed() + ".spherewalk";
}

void NewSurveyForm::setPossible(bool isPossible) {
    m_isPossible = isPossible;
    showState();
}

void NewSurveyForm::showState() {
    const QString name = m_name->text().trimmed();
    const bool isTaken = QFileInfo::exists(folder());
    m_create->setEnabled(m_isPossible && !name.isEmpty() && !name.contains('/') && !isTaken);
    m_create->setToolTip(isTaken ? tr("There is a survey of this name already.")
                                 : tr("Makes the survey on the disk."));
    m_place->setText(QDir(m_placeFolder).dirName());
    m_place->setToolTip(QDir::toNativeSeparators(m_placeFolder));
}

void NewSurveyForm::choosePlace() {
    const QString place =
        QFileDialog::getExistingDirectory(this, tr("Where surveys are kept"), m_placeFolder);
    if (!place.isEmpty()) {
        m_placeFolder = place;
        QSettings().setValue(kPlaceKey, place);
        showState();
    }
}

} // namespace spherewalk::ui
