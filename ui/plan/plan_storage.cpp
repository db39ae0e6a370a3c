// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plan/plan_storage.h"

#include "spherewalk/base/error.h"

#include <QFileInfo>

namespace spherewalk::ui {

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
            read();
        }
    });
    read();
}

void PlanStorage::read() {
    const SurveyState& survey = m_session->state();
    const store::Counts& counts = survey.counts;
    const bool isLocked =
        counts.photos + counts.openShots + counts.unclearShots > 0 || m_session->isReadOnly();
    if (isLocked && m_state == State::Locked) {
        return; // as it was
    }
    m_isReading = true;
    m_editor.setLocked(isLocked);
    m_editor.begin({survey.room, survey.options});
    m_isReading = false;
    setState(isLocked ? State::Locked : State::Stored);
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
            store.replacePlan(draft.room, draft.options, outcome.plan);
        });
        setState(State::Stored);
    } catch (const Error& error) {
        emit problem(QString::fromStdString(error.sentence()));
    }
    m_isWriting = false;
}

} // namespace spherewalk::ui
