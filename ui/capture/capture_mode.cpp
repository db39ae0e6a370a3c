// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/capture_mode.h"

#include "ui/capture/camera_panel.h"
#include "ui/capture/desk_words.h"
#include "ui/capture/operator_signals.h"
#include "ui/look/icon.h"
#include "ui/look/side_panel.h"
#include "ui/look/theme.h"
#include "ui/look/told_label.h"
#include "ui/look/words.h"
#include "ui/map/station_words.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QPainter>
#include <QPushButton>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <tuple>
#include <utility>

namespace spherewalk::ui {

using State = CaptureDesk::State;

namespace {

/// Whether the key is easily found without looking, or is one that presenters send.
bool isShutterKey(int key) {
    return key == Qt::Key_Space || key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_PageDown ||
           key == Qt::Key_Right || key == Qt::Key_F5;
}

constexpr int kEdgePx = 18; ///< Width of the coloured edge of the cart's view.

QColor verdictColour(survey::Quality quality) {
    return quality == survey::Quality::Good       ? goodColour()
           : quality == survey::Quality::Doubtful ? doubtfulColour()
                                                  : failedColour();
}

} // namespace

CaptureMode::CaptureMode(TaskList& tasks, QWidget* parent)
    : Mode("capture", tr("Capture"), tr("Take the photos, station by station"), parent),
      m_desk(tasks),
      m_finder(tasks),
      m_sounds(std::make_unique<BellSounds>()),
      m_plan(new CapturePlanView(m_desk, this)),
      m_camera(new CameraPanel(m_desk, m_finder, this)) {
    auto* side = new QWidget(this);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(16, 8, 16, 8);
    column->setSpacing(8);
    column->addWidget(m_camera);
    column->addWidget(makeTarget(), 3);
    column->addWidget(makeVerdict());
    m_figures = makeFigures();
    column->addWidget(m_figures, 1);
    m_againSection = makeAgain();
    column->addWidget(m_againSection);
    auto* splitter = new QSplitter(this);
    splitter->addWidget(m_plan);
    splitter->addWidget(side);
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 1);
    splitter->setSizes({900, 1100});
    splitter->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(splitter);
    setFocusPolicy(Qt::StrongFocus);
    m_plan->installEventFilter(this);
    for (auto* button : findChildren<QAbstractButton*>()) {
        button->installEventFilter(this);
    }
    connect(&m_desk, &CaptureDesk::changed, this, &CaptureMode::showAll);
    connect(&m_desk, &CaptureDesk::verdictGiven, this,
            [this](survey::Quality quality) { m_sounds->play(quality); });
    connect(&m_desk, &CaptureDesk::countdownTicked, this, [this](int /*left*/) { m_sounds->tick(); });
    connect(&m_desk, &CaptureDesk::runEnded, this, [this](bool isComplete) {
        emit message(m_desk.isByHand() ? tr("The walk has ended; another one goes on from here.")
                     : isComplete      ? tr("Every station has its photo.")
                                       : tr("Capturing has ended; it goes on where it stopped."));
    });
    connect(&m_desk.login(), &CameraLogin::trouble, this, &CaptureMode::message);
    connect(m_camera, &CameraPanel::remoteWanted, this, &CaptureMode::remoteWanted);
    showAll();
}

CaptureMode::~CaptureMode() = default;

void CaptureMode::setSession(SurveySession* session) {
    m_desk.setSession(session);
    m_plan->setSession(session);
    if (session != nullptr) {
        connect(session->selection(), &StationSelection::currentChanged, this, &CaptureMode::showAgain);
    }
    showAll();
}

void CaptureMode::showRemote(bool isOn) {
    m_camera->showRemote(isOn);
}

void CaptureMode::activated() {
    setFocus();
}

void CaptureMode::showPart(const QString& part) {
    m_camera->showPart(part);
}

QWidget* CaptureMode::makeTarget() {
    auto* target = new QWidget(this);
    auto* column = new QVBoxLayout(target);
    column->setContentsMargins(0, 0, 0, 0);
    m_state = new QLabel(target);
    m_state->setObjectName("captureState");
    m_state->setWordWrap(true); // large words do not make the window wider
    m_next = new BigText(target);
    m_next->setObjectName("nextStation");
    m_way = new QLabel(target);
    m_way->setObjectName("way");
    m_way->setWordWrap(true);
    QFont wayFont = m_way->font();
    wayFont.setPointSizeF(1.35 * wayFont.pointSizeF());
    m_way->setFont(wayFont);
    m_key = new QPushButton(target);
    m_key->setObjectName("shutter");
    m_key->setToolTip(tr("Space, Return, Page Down, or a presenter's button."));
    m_key->setMinimumHeight(64);
    makePrimary(m_key);
    QFont keyFont = m_key->font();
    keyFont.setPointSizeF(1.8 * keyFont.pointSizeF());
    m_key->setFont(keyFont);
    m_state->setFont(wayFont);
    m_key->setFocusPolicy(Qt::NoFocus); // its keys are the page's
    m_stop = new QPushButton(ui::icon("stop"), tr("&Stop"), target);
    m_stop->setObjectName("stopCapture");
    m_stop->setMinimumHeight(64);
    m_stop->setFocusPolicy(Qt::NoFocus);
    m_stop->setToolTip(tr("Ends after what is stored already; capturing goes on from there later (Escape)."));
    auto* row = new QHBoxLayout;
    row->addWidget(m_key, 1);
    row->addWidget(m_stop);
    column->addWidget(m_state);
    column->addWidget(m_next, 1);
    column->addWidget(m_way);
    column->addLayout(row);
    column->addWidget(makeNext());
    connect(m_key, &QPushButton::clicked, &m_desk, &CaptureDesk::trigger);
    connect(m_stop, &QPushButton::clicked, &m_desk, &CaptureDesk::end);
    return target;
}

/// Makes the buttons of the end. Each has a key of its own, and the shutter key presses the first.
QWidget* CaptureMode::makeNext() {
    m_whatNext = new QWidget(this);
    auto* row = new QHBoxLayout(m_whatNext);
    row->setContentsMargins(0, 0, 0, 0);
    const auto add = [&](const char* name) {
        auto* button = new QPushButton(m_whatNext);
        button->setObjectName(name);
        button->setMinimumHeight(48);
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button, 1);
        return button;
    };
    m_toReview = add("lookAtDoubtful");
    m_retakeDoubtful = add("retakeDoubtful");
    m_toAlign = add("goToAlign");
    m_toAlign->setText(tr("Align (A)"));
    connect(m_toReview, &QPushButton::clicked, this, [this] { emit pageRequested("review", "doubtful"); });
    connect(m_retakeDoubtful, &QPushButton::clicked, &m_desk, &CaptureDesk::takeDoubtfulAgain);
    connect(m_toAlign, &QPushButton::clicked, this, [this] { emit pageRequested("align"); });
    return m_whatNext;
}

QWidget* CaptureMode::makeVerdict() {
    auto* verdict = new QWidget(this);
    auto* row = new QHBoxLayout(verdict);
    row->setContentsMargins(0, 0, 0, 0);
    m_verdictIcon = new QLabel(verdict);
    m_verdict = new ToldLabel(verdict);
    m_verdict->setObjectName("verdict");
    QFont font = m_verdict->font();
    font.setPointSizeF(1.35 * font.pointSizeF());
    m_verdict->setFont(font);
    row->addWidget(m_verdictIcon, 0, Qt::AlignTop);
    row->addWidget(m_verdict, 1);
    return verdict;
}

QWidget* CaptureMode::makeFigures() {
    auto* figures = new QWidget(this);
    auto* grid = new QGridLayout(figures);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(20);
    int column = 0;
    const auto add = [&](const QString& name, const QString& objectName) {
        auto* figure = new BigText(figures);
        figure->setObjectName(objectName);
        figure->setMaximumHeight(80);
        auto* label = new QLabel(name, figures);
        grid->addWidget(figure, 0, column);
        grid->addWidget(label, 1, column);
        grid->setColumnStretch(column, 1);
        ++column;
        return std::pair(figure, label);
    };
    std::tie(m_photosLeft, m_photosLeftName) = add({}, "photosLeft");
    std::tie(m_timeLeft, m_timeLeftName) = add({}, "timeLeft");
    m_pace = add(tr("photos a minute"), "pace").first;
    return figures;
}

QWidget* CaptureMode::makeAgain() {
    auto* section = new Section(tr("To be taken again"), this);
    m_againTitle = section->title();
    m_again = new QListWidget(section);
    m_again->setObjectName("retakes");
    m_again->setAccessibleName(tr("To be taken again"));
    m_again->setMaximumHeight(84);
    section->layout()->addWidget(m_again);
    m_takeAgain = new QPushButton(ui::icon("retake"), QString(), section);
    m_takeAgain->setObjectName("takeAgain");
    m_takeAgain->setToolTip(
        tr("Puts the station that is selected on the plan on the list, or takes it off."));
    section->layout()->addWidget(m_takeAgain);
    connect(m_takeAgain, &QPushButton::clicked, this, &CaptureMode::toggleAgain);
    connect(m_again, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        m_desk.setAgain(item->data(Qt::UserRole).toLongLong(), false);
        m_plan->refresh();
    });
    return section;
}

void CaptureMode::toggleAgain() {
    if (m_desk.session() == nullptr) {
        return;
    }
    if (const auto station = m_desk.session()->selection()->current()) {
        m_desk.setAgain(*station, !m_desk.isAgain(*station));
        m_plan->refresh();
    }
}

void CaptureMode::showAll() {
    const bool hidesPractice = m_isWhole && m_desk.hasPracticeCamera(); // its own line is not shown then
    m_state->setText(hidesPractice ? tr("PRACTICE. %1").arg(stateWords(m_desk)) : stateWords(m_desk));
    const bool countsDown = m_isWhole && m_desk.state() == State::Hiding;
    m_next->setText(countsDown ? QString::number(m_desk.countdown()) : m_desk.nextText());
    m_way->setText(m_desk.wayText());
    m_key->setText(keyWords(m_desk));
    m_key->setEnabled(m_desk.takesKey());
    showNext();
    m_stop->setVisible(m_desk.isRunning());
    showFigures();
    const auto pace = m_desk.photosAMinute();
    m_pace->setText(pace ? QLocale().toString(*pace, 'f', 1) : QString::fromUtf8("–"));
    showVerdict();
    showAgain();
    takeFocus();
}

/// Shows what is left to be taken; by hand, nobody knows, and it shows what there is.
void CaptureMode::showFigures() {
    const bool isByHand = m_desk.isByHand();
    m_photosLeftName->setText(isByHand ? tr("photos taken") : tr("photos left"));
    m_timeLeftName->setText(isByHand ? tr("of known place") : tr("time left"));
    if (!isByHand) {
        m_photosLeft->setText(QString::number(m_desk.stationsLeft()));
        m_timeLeft->setText(durationText(m_desk.timeLeft()));
        return;
    }
    const SurveyState& survey = m_desk.session()->state();
    m_photosLeft->setText(QString::number(survey.counts.stationsWithPhoto));
    m_timeLeft->setText(QString::number(std::ranges::count_if(
        survey.stations, [&](const auto& station) { return m_desk.isPlaced(station); })));
}

/// Shows what was taken and what comes next, in place of the key, once every station has its photo. A walk by
/// hand can go on as well.
void CaptureMode::showNext() {
    const bool isComplete = m_desk.isComplete();
    const bool isAfterWalk = m_desk.isByHand() && !m_desk.isRunning() && m_desk.stations() > 0;
    m_whatNext->setVisible(isComplete || isAfterWalk);
    m_key->setVisible(!isComplete);
    if (!isComplete && !isAfterWalk) {
        return;
    }
    const SurveyState& survey = m_desk.session()->state();
    const int doubtful = survey.count(Standing::Doubtful);
    const int failed = survey.count(Standing::Failed);
    const bool isKnown = !isAfterWalk || !survey.hasUnknownPlaces();
    if (isComplete) {
        m_next->setText(
            tr("%1 taken, %2 doubtful, %3 failed").arg(m_desk.stations()).arg(doubtful).arg(failed));
    }
    const bool isDoubtful = doubtful + failed > 0;
    m_toReview->setVisible(isDoubtful);
    m_retakeDoubtful->setVisible(isDoubtful && isKnown);
    m_toReview->setText(tr("Look at %n in Review (R)", nullptr, doubtful + failed));
    m_retakeDoubtful->setText(tr("Take %n again (T)", nullptr, doubtful + failed));
    m_toAlign->setStyleSheet({});
    m_toReview->setStyleSheet({});
    if (isComplete) { // after a walk, the key is the main one
        makePrimary(isDoubtful ? m_toReview : m_toAlign);
    }
    m_way->setText(isAfterWalk && isKnown ? tr("Go on where photos are missing.")
                   : isAfterWalk          ? tr("Go on, or solve where the photos were taken.")
                   : isDoubtful           ? tr("Look at the doubtful photos while the rail is still here.")
                                          : tr("Next: solve how each photo is turned."));
}

/// Does what the shutter key means once every station has its photo.
void CaptureMode::goOn() {
    (m_toReview->isVisibleTo(this) ? m_toReview : m_toAlign)->click();
}

void CaptureMode::setWholeScreen(bool isWhole) {
    constexpr double kFromAfar = 2.4;
    if (isWhole == m_isWhole) {
        return;
    }
    m_isWhole = isWhole;
    for (QWidget* near : {static_cast<QWidget*>(m_camera), m_figures, m_againSection}) {
        near->setVisible(!isWhole);
    }
    for (QWidget* words : std::initializer_list<QWidget*>{m_state, m_way, m_verdict, m_key, m_stop}) {
        QFont font = words->font();
        font.setPointSizeF(font.pointSizeF() * (isWhole ? kFromAfar : 1 / kFromAfar));
        words->setFont(font);
    }
    constexpr int kKeyPx = 64;
    for (QWidget* key : {m_key, m_stop}) {
        key->setMinimumHeight(isWhole ? 2 * kKeyPx : kKeyPx);
    }
    const int edge = isWhole ? kEdgePx : 0;
    layout()->setContentsMargins(edge, edge, edge, edge);
    showAll();
}

QList<Mode::Key> CaptureMode::keys() const {
    return {{tr("Space, Return, Page Down"), tr("Start, shoot, try again, or end the countdown")},
            {tr("Escape"), tr("Stop capturing")},
            {QStringLiteral("R, T, A"), tr("At the end: review, take again, align")}};
}

/// Draws the edge of the cart's view.
void CaptureMode::paintEvent(QPaintEvent* event) {
    Mode::paintEvent(event);
    if (m_isWhole && m_shownVerdict) {
        QPainter painter(this);
        painter.fillRect(rect(), verdictColour(*m_shownVerdict));
        painter.fillRect(rect().adjusted(kEdgePx, kEdgePx, -kEdgePx, -kEdgePx),
                         palette().color(QPalette::Window));
    }
}

/// Gives the page the focus when the shutter can be pressed. Otherwise Space would press the button that was
/// clicked last.
void CaptureMode::takeFocus() {
    const State state = m_desk.state();
    const bool isNew = std::exchange(m_shownState, state) != state;
    if (isNew && isVisible() &&
        (state == State::Ready || state == State::AtStation || state == State::AskAgain)) {
        setFocus();
    }
}

void CaptureMode::showVerdict() {
    const std::optional<survey::Quality> verdict = m_desk.verdict();
    if (verdict != m_shownVerdict) {
        constexpr int kIconPx = 36;
        m_verdictIcon->setPixmap(
            verdict ? colouredIcon(QString::fromUtf8(name(*verdict)), verdictColour(*verdict), kIconPx)
                    : QPixmap());
        m_shownVerdict = verdict;
        update(); // the edge has its colour
    }
    m_verdict->tell(resultWords(m_desk));
    m_verdictIcon->setVisible(!m_verdict->text().isEmpty()); // a sign alone tells nothing
}

void CaptureMode::showAgain() {
    const auto stations = m_desk.again();
    m_again->clear();
    for (const store::StationRecord& station : stations) {
        auto* item = new QListWidgetItem(stationWords(station.name), m_again);
        item->setData(Qt::UserRole, static_cast<qlonglong>(station.id));
    }
    m_again->setVisible(!stations.empty());
    m_againTitle->setVisible(!stations.empty()); // the button speaks for itself, and a small screen is full
    const auto selected =
        m_desk.session() != nullptr ? m_desk.session()->selection()->current() : std::nullopt;
    m_takeAgain->setEnabled(selected && !m_desk.isRunning());
    m_takeAgain->setText(selected && m_desk.isAgain(*selected) ? tr("Do not take it again")
                                                               : tr("Take the selected station again"));
}

void CaptureMode::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) {
        return m_desk.end();
    }
    if (m_whatNext->isVisibleTo(this) && !event->isAutoRepeat()) {
        QPushButton* button = event->key() == Qt::Key_R   ? m_toReview
                              : event->key() == Qt::Key_T ? m_retakeDoubtful
                              : event->key() == Qt::Key_A ? m_toAlign
                                                          : nullptr;
        if (button != nullptr && button->isVisibleTo(this)) {
            return button->click();
        }
        if (isShutterKey(event->key()) && m_desk.isComplete()) {
            return goOn();
        }
    }
    if (!isShutterKey(event->key())) {
        return Mode::keyPressEvent(event);
    }
    if (!event->isAutoRepeat()) { // a key held down is one shot
        m_desk.trigger();
    }
}

bool CaptureMode::eventFilter(QObject* watched, QEvent* event) {
    // The plan has the focus after a click, and a button after a Tab; the key must work all the same.
    const bool takesKeys = watched == m_plan || m_desk.isRunning();
    if (takesKeys && event->type() == QEvent::KeyPress) {
        auto* key = static_cast<QKeyEvent*>(event);
        if (isShutterKey(key->key()) && key->key() != Qt::Key_Right) {
            keyPressEvent(key);
            return true;
        }
    }
    return Mode::eventFilter(watched, event);
}

} // namespace spherewalk::ui
