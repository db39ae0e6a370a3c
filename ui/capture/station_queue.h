// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/survey_session.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/jobs/capture_survey.h"
#include "spherewalk/survey/marking.h"

#include <QString>

#include <chrono>
#include <optional>
#include <set>
#include <vector>

namespace spherewalk::ui {

/// Estimates how long the remaining photos take. The plan's pace counts first, and the operator's own pace
/// from the third photo on.
class Pace {
  public:
    static constexpr int kKnown = 3; ///< From this many photos on, the operator's own pace counts.

    /// Begins a run: forgets the photos of the run before.
    void begin(Clock::TimePoint now) {
        m_begin = now;
        m_last = now;
        m_photos = 0;
    }

    void photo(Clock::TimePoint now) {
        ++m_photos;
        m_last = now;
    }

    int photos() const { return m_photos; }

    /// Returns the pace of this run up to its latest photo, and nothing before kKnown photos.
    std::optional<double> photosAMinute() const {
        const double minutes = std::chrono::duration<double>(m_last - m_begin).count() / 60;
        return m_photos >= kKnown && minutes > 0 ? std::optional(m_photos / minutes) : std::nullopt;
    }

    /// Returns how long this many photos on this many rails will take.
    std::chrono::duration<double> left(int photos, int rails, const survey::PlanOptions& plan) const {
        if (const auto own = photosAMinute()) {
            return std::chrono::duration<double>(60 * photos / *own);
        }
        return std::chrono::duration<double>(photos * plan.secondsPerPhoto +
                                             rails * plan.secondsPerPlacement);
    }

  private:
    Clock::TimePoint m_begin{};
    Clock::TimePoint m_last{};
    int m_photos = 0;
};

/// The stations that still need a photo, in walking order: those without one, and those that a person wants
/// to take again. It also knows the way to the next station. A survey by hand has no such stations: photos
/// are taken wherever the operator stands. Frames: room.
class StationQueue {
  public:
    /// Begins with another survey; null: no survey.
    void begin(const SurveyState* survey);
    /// Marks the rails of a changed plan. Cost: tape distances take their time in a large room.
    void markRails(const SurveyState* survey);
    /// Takes from the survey which stations have no photo. next() stays.
    void read(const SurveyState* survey);

    int size() const { return static_cast<int>(m_stations.size()); }

    /// Whether the next photo is taken by hand, see jobs::isByHand().
    bool isByHand() const { return m_isByHand; }

    /// Tells that the photo with this number of a run by hand comes next, counted from 1.
    void walkTo(int photo) { m_photo = m_photosBefore + photo; }

    /// Takes what is known by now of the photos' places.
    void setPlaces(const jobs::PlacesFound& places) { m_places = places; }

    /// What is known by now of the places of photos by hand; nothing before the first look.
    const std::optional<jobs::PlacesFound>& places() const { return m_places; }

    /// Whether the plan can show where this station is.
    bool isPlaced(const store::StationRecord& station) const;

    /// Returns the station of the next photo; nothing if the queue was empty at goToFirst().
    const std::optional<store::StationRecord>& next() const { return m_next; }

    void goToFirst();

    void goTo(const store::StationRecord& station) { m_next = station; }

    /// Tells that the cart stands at next().
    void arrive() { m_last = m_next; }

    /// Returns how the rail of next() is laid; null while the cart is on it, and without a rail.
    const survey::RailMark* railToLay() const;

    /// Returns the name of next(), "Rail 3, stop 5", or of the next photo by hand.
    QString nextWords() const;

    /// Says how the cart gets to next(): by rolling on, or by laying the rail, with tape distances. In a flat
    /// with named rooms, the room comes first, with how many of its stations have a photo.
    QString wayWords() const;

    /// Returns the stations of the queue that a person wants to take again.
    std::vector<store::StationRecord> again() const;

    bool isAgain(std::int64_t station) const { return m_again.contains(station); }

    const std::set<std::int64_t>& againIds() const { return m_again; }

    /// Takes effect with the next read().
    void setAgain(std::int64_t station, bool isAgain);

    /// Wants every station again whose photo is doubtful or failed. Takes effect with the next read().
    void takeDoubtfulAgain(const SurveyState& survey);

    Pace& pace() { return m_pace; }

    const Pace& pace() const { return m_pace; }

    /// Estimates how long the photos of the queue take.
    std::chrono::duration<double> timeLeft(const survey::PlanOptions& plan) const;

  private:
    /// How far a named room of a flat is.
    struct Room {
        QString name;
        int stations = 0;
        int taken = 0;
    };

    QString roomWords() const;
    QString walkWords() const;
    void countRooms(const SurveyState& survey);

    std::vector<store::StationRecord> m_stations;
    std::set<std::int64_t> m_again;
    bool m_isByHand = false;
    int m_photosInSurvey = 0;
    int m_photosBefore = 0; ///< In the survey when the run by hand began.
    int m_photo = 1;        ///< Number of the next photo by hand.
    std::optional<jobs::PlacesFound> m_places;
    std::optional<store::StationRecord> m_next;
    std::optional<store::StationRecord> m_last; ///< Where the cart stood last.
    survey::Room m_room;
    std::vector<survey::RailMark> m_rails;
    std::vector<Room> m_rooms;
    std::vector<std::size_t> m_roomOfRail; ///< Index into m_rooms; empty where rooms have no names.
    Pace m_pace;
};

} // namespace spherewalk::ui
