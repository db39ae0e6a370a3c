// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/station_queue.h"

#include "ui/map/station_words.h"

#include "spherewalk/survey/room_parts.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace spherewalk::ui {

void StationQueue::begin(const SurveyState* survey) {
    m_again.clear();
    m_last.reset();
    m_next.reset();
    m_pace = {};
    markRails(survey);
    read(survey);
}

void StationQueue::markRails(const SurveyState* survey) {
    m_room = survey != nullptr ? survey->room : survey::Room();
    m_rails = survey != nullptr ? survey::railMarks(m_room, survey->plan) : std::vector<survey::RailMark>();
    m_rooms.clear();
    m_roomOfRail.clear();
    if (!m_room.names.empty()) {
        const survey::RoomParts parts(m_room);
        m_roomOfRail = parts.ofRails(survey->plan);
        for (const std::string& name : parts.names()) {
            m_rooms.push_back({QString::fromStdString(name), 0, 0});
        }
    }
}

void StationQueue::read(const SurveyState* survey) {
    m_stations.clear();
    if (survey == nullptr) {
        return;
    }
    std::copy_if(survey->stations.begin(), survey->stations.end(), std::back_inserter(m_stations),
                 [&](const store::StationRecord& station) {
                     return m_again.contains(station.id) || survey->missing.contains(station.id);
                 });
    countRooms(*survey);
}

void StationQueue::countRooms(const SurveyState& survey) {
    for (Room& room : m_rooms) {
        room.stations = room.taken = 0;
    }
    for (const store::StationRecord& station : survey.stations) {
        const auto rail = static_cast<std::size_t>(station.station.placement);
        if (station.station.placement >= 0 && rail < m_roomOfRail.size()) {
            Room& room = m_rooms[m_roomOfRail[rail]];
            ++room.stations;
            room.taken += survey.missing.contains(station.id) ? 0 : 1;
        }
    }
}

QString StationQueue::roomWords() const {
    const auto rail = static_cast<std::size_t>(m_next ? m_next->station.placement : -1);
    if (!m_next || m_next->station.placement < 0 || rail >= m_roomOfRail.size()) {
        return {};
    }
    const Room& room = m_rooms[m_roomOfRail[rail]];
    return QCoreApplication::translate("spherewalk::ui::StationQueue", "%1: %2 of %3 taken")
        .arg(room.name)
        .arg(room.taken)
        .arg(room.stations);
}

const survey::RailMark* StationQueue::railToLay() const {
    if (!m_next || m_next->station.placement < 0) {
        return nullptr;
    }
    const int placement = m_next->station.placement;
    const bool isOnRail = m_last && m_last->station.placement == placement;
    return isOnRail ? nullptr : &m_rails[static_cast<std::size_t>(placement)];
}

QString StationQueue::wayWords() const {
    const survey::RailMark* rail = railToLay();
    const QString way = rail != nullptr ? railWords(*rail, m_room)
                        : m_next        ? positionWords(m_next->station)
                                        : QString();
    const QString room = roomWords();
    return room.isEmpty() ? way : room + QLatin1Char('\n') + way;
}

std::vector<store::StationRecord> StationQueue::again() const {
    std::vector<store::StationRecord> result;
    std::copy_if(m_stations.begin(), m_stations.end(), std::back_inserter(result),
                 [this](const store::StationRecord& station) { return m_again.contains(station.id); });
    return result;
}

void StationQueue::setAgain(std::int64_t station, bool isAgain) {
    if (isAgain) {
        m_again.insert(station);
    } else {
        m_again.erase(station);
    }
}

std::chrono::duration<double> StationQueue::timeLeft(const survey::PlanOptions& plan) const {
    std::set<int> rails;
    for (const store::StationRecord& station : m_stations) {
        rails.insert(station.station.placement);
    }
    return m_pace.left(size(), static_cast<int>(rails.size()), plan);
}

} // namespace spherewalk::ui
