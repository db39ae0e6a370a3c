// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/station_queue.h"

#include "ui/map/station_words.h"

#include "spherewalk/survey/room_parts.h"

#include <QCoreApplication>

#include <algorithm>
#include <iterator>

namespace spherewalk::ui {

namespace {

/// The words of this file, for translators.
struct QueueWords {
    Q_DECLARE_TR_FUNCTIONS(spherewalk::ui::StationQueue)
};

} // namespace

void StationQueue::begin(const SurveyState* survey) {
    m_again.clear();
    m_last.reset();
    m_next.reset();
    m_pace = {};
    m_places.reset();
    markRails(survey);
    read(survey);
}

void StationQueue::markRails(const SurveyState* survey) {
    m_room = survey != nullptr ? survey->room : survey::Room();
    const bool hasRails = survey != nullptr && !survey->plan.placements.empty();
    m_rails = hasRails ? survey::railMarks(m_room, survey->plan) : std::vector<survey::RailMark>();
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
    m_isByHand = false;
    if (survey == nullptr) {
        return;
    }
    std::copy_if(survey->stations.begin(), survey->stations.end(), std::back_inserter(m_stations),
                 [&](const store::StationRecord& station) {
                     const bool isWanted =
                         m_again.contains(station.id) || survey->missing.contains(station.id);
                     return isWanted && station.isPlaceKnown; // Else nobody can go there.
                 });
    m_isByHand = m_stations.empty() && survey->plan.placements.empty();
    m_photosInSurvey = survey->counts.stationsWithPhoto;
    countRooms(*survey);
}

void StationQueue::goToFirst() {
    m_next = m_stations.empty() ? std::nullopt : std::optional(m_stations.front());
    m_photosBefore = m_photosInSurvey;
    walkTo(1);
}

bool StationQueue::isPlaced(const store::StationRecord& station) const {
    return station.isPlaceKnown || (m_places && std::ranges::count(m_places->placed, station.id) > 0);
}

QString StationQueue::nextWords() const {
    return m_isByHand ? QueueWords::tr("Photo %1").arg(m_photo)
           : m_next   ? stationWords(m_next->name)
                      : QString();
}

QString StationQueue::walkWords() const {
    if (!m_places) {
        return QueueWords::tr(
            "Hold the camera upright and still. Take the next photo about half a metre on.");
    }
    const int placed = static_cast<int>(m_places->placed.size());
    if (m_places->unplaced.empty()) {
        return QueueWords::tr("%n photo(s) found their place. Walk on about half a metre.", nullptr, placed);
    }
    return QueueWords::tr("%1 of %2 photos found their place. Take some between the others and these.")
        .arg(placed)
        .arg(m_places->photos);
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
    return QueueWords::tr("%1: %2 of %3 taken").arg(room.name).arg(room.taken).arg(room.stations);
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
    if (m_isByHand) {
        return walkWords();
    }
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

void StationQueue::takeDoubtfulAgain(const SurveyState& survey) {
    for (const auto& [station, standing] : survey.standings) {
        if (standing == Standing::Doubtful || standing == Standing::Failed) {
            m_again.insert(station);
        }
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
