// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/capture/station_queue.h"

#include "ui/map/station_words.h"

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
    return rail != nullptr ? railWords(*rail, m_room) : m_next ? positionWords(m_next->station) : QString();
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
