// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/map/plan_view.h"

#include "ui/look/theme.h"
#include "ui/map/station_words.h"

#include "spherewalk/base/statistics.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QToolTip>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace spherewalk::ui {

namespace {

/// Returns the usual distance of neighbours along the walk, which on a plan is the step of its grid.
double spacing(const std::vector<StationMark>& marks) {
    constexpr double kSamePlaceM = 1e-3;
    std::vector<double> distances;
    for (std::size_t i = 1; i < marks.size(); ++i) {
        const double distance = (marks[i].positionM - marks[i - 1].positionM).norm();
        if (distance > kSamePlaceM) {
            distances.push_back(distance);
        }
    }
    return distances.empty() ? 1 : median(std::move(distances));
}

} // namespace

PlanView::PlanView(QWidget* parent) : PlanCanvas(parent) {
    connect(this, &PlanCanvas::pressedAt, this, [this](const QPointF& pInRoom) {
        if (const StationMark* mark = markAt(widgetFromRoom().map(pInRoom))) {
            emit stationClicked(mark->id);
        }
    });
}

void PlanView::setRoom(const survey::Room& room, Qt::PenStyle walls) {
    m_room = room;
    m_walls = walls;
    showAll();
}

void PlanView::setStations(std::vector<StationMark> stations) {
    m_stations = std::move(stations);
    m_spacingM = spacing(m_stations);
    showAll();
}

void PlanView::showAll() {
    constexpr double kAroundM = 1; // So that one photo is not the whole plan.
    Polygon corners = m_room.outline;
    for (const StationMark& mark : m_stations) {
        corners.push_back(mark.positionM);
    }
    if (!corners.empty()) {
        Bounds2 extent = bounds(corners);
        if (m_room.outline.empty()) {
            extent.least.array() -= kAroundM;
            extent.greatest.array() += kAroundM;
        }
        setExtent(extent);
    }
    update();
}

void PlanView::setCurrent(std::optional<std::int64_t> station) {
    m_current = station;
    update();
}

QColor PlanView::heatColour(double heat) {
    // Between three colours whose lightness falls steadily: light yellow, orange, dark violet.
    constexpr std::array<std::array<double, 3>, 3> kStops = {
        {{0.99, 0.91, 0.55}, {0.93, 0.46, 0.22}, {0.31, 0.07, 0.36}}};
    const double at = std::clamp(heat, 0.0, 1.0) * 2;
    const std::size_t from = at < 1 ? 0 : 1;
    const double share = at - static_cast<double>(from);
    const auto mix = [&](std::size_t channel) {
        return static_cast<float>((1 - share) * kStops[from][channel] + share * kStops[from + 1][channel]);
    };
    return QColor::fromRgbF(mix(0), mix(1), mix(2));
}

QString PlanView::words() const {
    return m_room.outline.empty() && m_stations.empty() ? emptyText() : QString();
}

QString PlanView::emptyText() const {
    return tr("No survey is open");
}

bool PlanView::showsGrid() const {
    return words().isEmpty();
}

double PlanView::stationRadiusPx() const {
    constexpr double kShareOfSpacing = 0.3;
    return std::clamp(kShareOfSpacing * m_spacingM * pixelsPerMetre(), 2.0, 12.0);
}

const StationMark* PlanView::markAt(const QPointF& at) const {
    const QTransform transform = widgetFromRoom();
    const StationMark* nearest = nullptr;
    double least = 2 * stationRadiusPx();
    for (const StationMark& mark : m_stations) {
        const QPointF place = mapped(mark.positionM, transform);
        const double distance = QLineF(place, at).length();
        if (distance <= least) {
            nearest = &mark;
            least = distance;
        }
    }
    return nearest;
}

void PlanView::paintFloor(QPainter& painter, const QTransform& widgetFromRoom) {
    if (const QString sentence = words(); !sentence.isEmpty()) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, sentence);
        return;
    }
    if (!m_room.outline.empty()) {
        paintRoom(painter, m_room, palette().color(QPalette::Base), widgetFromRoom, m_walls);
        paintNames(painter, m_room, widgetFromRoom);
    }
    for (const StationMark& mark : m_stations) {
        const QPointF at = mapped(mark.positionM, widgetFromRoom);
        paintMark(painter, mark, at);
        if (mark.id == m_current) {
            painter.setPen(QPen(palette().color(QPalette::WindowText), 2.5));
            painter.setBrush(Qt::NoBrush);
            const double radius = stationRadiusPx() + 4;
            painter.drawEllipse(at, radius, radius);
        }
    }
}

void PlanView::paintMark(QPainter& painter, const StationMark& mark, const QPointF& at) const {
    const double r = stationRadiusPx();
    const QColor base = mark.standing == Standing::Doubtful ? doubtfulColour()
                        : mark.standing == Standing::Failed ? failedColour()
                                                            : palette().color(QPalette::Highlight);
    const QColor colour = mark.heat ? heatColour(*mark.heat) : base;
    painter.setPen(QPen(colour, r > 4 ? 2 : 1.2));
    painter.setBrush(colour);
    switch (mark.standing) {
    case Standing::Missing:
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, r, r);
        break;
    case Standing::Taken:
    case Standing::Accepted:
        painter.drawEllipse(at, r, r);
        break;
    case Standing::Doubtful:
        painter.drawPolygon(QPolygonF(
            {at + QPointF(0, -1.2 * r), at + QPointF(1.1 * r, 0.8 * r), at + QPointF(-1.1 * r, 0.8 * r)}));
        break;
    case Standing::Failed:
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(QRectF(at.x() - r, at.y() - r, 2 * r, 2 * r));
        painter.drawLine(at + QPointF(-r, -r), at + QPointF(r, r));
        painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
        break;
    case Standing::Rejected:
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(at, r, r);
        painter.drawLine(at + QPointF(-r, r), at + QPointF(r, -r));
        break;
    }
}

bool PlanView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) {
        return PlanCanvas::event(event);
    }
    const auto* help = static_cast<QHelpEvent*>(event);
    if (const StationMark* mark = markAt(help->pos())) {
        QToolTip::showText(help->globalPos(),
                           mark->note.isEmpty() ? mark->name : mark->name + "\n" + mark->note, this);
    } else {
        QToolTip::hideText();
    }
    return true;
}

void PlanView::keyPressEvent(QKeyEvent* event) {
    const int step = event->key() == Qt::Key_Right || event->key() == Qt::Key_Down ? 1
                     : event->key() == Qt::Key_Left || event->key() == Qt::Key_Up  ? -1
                                                                                   : 0;
    if (step == 0 || m_stations.empty()) {
        return PlanCanvas::keyPressEvent(event);
    }
    const auto found = std::find_if(m_stations.begin(), m_stations.end(),
                                    [&](const StationMark& mark) { return mark.id == m_current; });
    const auto last = static_cast<std::ptrdiff_t>(m_stations.size()) - 1;
    const std::ptrdiff_t next = found == m_stations.end()
                                    ? 0
                                    : std::clamp<std::ptrdiff_t>(found - m_stations.begin() + step, 0, last);
    emit stationClicked(m_stations[static_cast<std::size_t>(next)].id);
}

SurveyPlanView::SurveyPlanView(QWidget* parent) : PlanView(parent) {
    connect(this, &PlanView::stationClicked, this, [this](std::int64_t station) {
        if (m_session) {
            m_session->selection()->setCurrent(station);
        }
    });
}

void SurveyPlanView::setSession(SurveySession* session) {
    if (m_session) {
        m_session->disconnect(this);
        m_session->selection()->disconnect(this);
    }
    m_session = session;
    if (session != nullptr) {
        connect(session, &SurveySession::changed, this, [this](SurveySession::Changes what) {
            if (what.testFlag(SurveySession::Plan)) {
                showRoom();
            }
            refresh();
        });
        connect(session->selection(), &StationSelection::currentChanged, this, &PlanView::setCurrent);
    }
    setCurrent(session != nullptr ? session->selection()->current() : std::nullopt);
    showRoom();
    refresh();
}

void SurveyPlanView::showRoom() {
    if (m_session) {
        setRoom(m_session->state().room, m_session->state().isRoomSolved() ? Qt::DashLine : Qt::SolidLine);
    } else {
        setRoom({});
    }
    fit();
}

QString SurveyPlanView::emptyText() const {
    return m_session ? tr("Nobody knows this room yet, nor where its photos stand") : PlanView::emptyText();
}

void SurveyPlanView::refresh() {
    setStations(m_session ? marks(m_session->state()) : std::vector<StationMark>());
}

bool SurveyPlanView::isPlaced(const store::StationRecord& station) const {
    return station.isPlaceKnown;
}

std::vector<StationMark> SurveyPlanView::marks(const SurveyState& survey) const {
    std::vector<StationMark> result;
    for (const store::StationRecord& station : survey.stations) {
        if (!isPlaced(station)) {
            continue;
        }
        StationMark mark;
        mark.id = station.id;
        mark.positionM = station.station.positionM.head<2>();
        mark.name = stationWords(station.name);
        mark.standing = survey.standings.at(station.id);
        mark.note = standingText(mark.standing);
        result.push_back(mark);
    }
    return result;
}

} // namespace spherewalk::ui
