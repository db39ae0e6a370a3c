// SPDX-License-Identifier: GPL-3.0-or-later
#include "capture/capture_run.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/text.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace spherewalk::jobs {

namespace {

/// Brings places to those that are shown already by quarter turns and a shift: walls lie along the axes
/// before and after. Shape: as many of both; without any, nothing is moved.
FloorMotion motionToShown(const std::vector<Eigen::Vector2d>& places,
                          const std::vector<Eigen::Vector2d>& shown) {
    if (places.empty()) {
        return {};
    }
    constexpr double kQuarter = std::numbers::pi / 2;
    const Eigen::Vector2d& first = places.front();
    const FloorMotion common =
        commonMotion(places, shown).value_or(FloorMotion{Eigen::Rotation2Dd(0), shown.front() - first});
    const Eigen::Rotation2Dd turn(kQuarter * std::round(common.turn.angle() / kQuarter));
    return {turn, common * first - turn * first};
}

} // namespace

std::string PlacesFound::sentence() const {
    if (!trouble.empty()) {
        return text("Where the photos were taken is not known yet. ", trouble);
    }
    if (photos == 0) {
        return "No place is known yet.";
    }
    if (unplaced.empty()) {
        return text(photos == 1 ? "The photo is" : "All photos are", " placed.");
    }
    std::string names;
    for (std::size_t i = 0; i < unplaced.size() && i < 3; ++i) {
        names += (i == 0 ? "" : ", ") + unplaced[i];
    }
    return text(placed.size(), " of ", photos, " photos are placed against each other. Not yet: ", names,
                unplaced.size() > 3 ? " and others" : "", "; take photos between them and the rest.");
}

PlaceFinder::PlaceFinder(SharedStore& store, Operator& people)
    : m_store(store), m_people(people), m_thread([this](const std::stop_token& stop) { run(stop); }) {
}

void PlaceFinder::wake() {
    {
        const std::scoped_lock lock(m_mutex);
        m_isWoken = true;
    }
    m_changed.notify_all();
}

PlacesFound PlaceFinder::finish(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, stop, [this] { return !m_isWoken && !m_isBusy; });
    throwIfStopped(stop);
    return m_found;
}

void PlaceFinder::run(const std::stop_token& stop) {
    for (;;) {
        {
            std::unique_lock lock(m_mutex);
            m_isBusy = false;
            m_changed.notify_all();
            if (!m_changed.wait(lock, stop, [this] { return m_isWoken; }) || stop.stop_requested()) {
                return;
            }
            m_isWoken = false;
            m_isBusy = true;
        }
        try {
            look(stop);
        } catch (const std::exception& error) { // No reason to end a walk: align says it once more.
            if (!stop.stop_requested()) {
                PlacesFound found = m_found;
                found.trouble = error.what();
                tell(found);
            }
        }
    }
}

void PlaceFinder::look(const std::stop_token& stop) {
    const auto folder = m_store.use([](const store::SurveyStore& store) { return store.folder(); });
    const auto reader = store::SurveyStore::open(folder, store::Access::Read);
    AlignOptions options;
    options.isFree = true;
    options.effort = align::Effort::Fine;
    const PlacesSoFar places = placesSoFar(reader, options, noProgress(), stop);
    tell(m_store.use([&](store::SurveyStore& store) { return show(store, places); }));
}

void PlaceFinder::tell(const PlacesFound& found) {
    {
        const std::scoped_lock lock(m_mutex);
        m_found = found;
    }
    m_people.placesFound(found);
}

/// Writes the places into a survey that has no others. Each look has a frame of its own, which is brought to
/// what is shown already, so that the room does not turn under people's eyes.
PlacesFound PlaceFinder::show(store::SurveyStore& store, const PlacesSoFar& found) {
    PlacesFound result;
    result.photos = static_cast<int>(found.photos.size());
    if (result.photos == 1) { // Wherever it is, the next ones are placed beside it.
        result.placed.push_back(store.photo(found.photos.front()).station);
        return result;
    }
    std::vector<store::PlacedStation> places;
    std::vector<Eigen::Vector2d> from;
    std::vector<Eigen::Vector2d> to;
    for (std::size_t i = 0; i < found.photos.size(); ++i) {
        const store::StationRecord station = store.station(store.photo(found.photos[i]).station);
        const auto& pose = found.places.photos[i].roomFromPhoto;
        if (!pose) {
            result.unplaced.push_back(station.name);
            continue;
        }
        result.placed.push_back(station.id);
        if (!station.isPlaceKnown) {
            places.push_back({station.id, pose->translation, {}, false});
        }
        if (station.isPlaceKnown || m_shown.contains(station.id)) {
            from.emplace_back(pose->translation.head<2>());
            to.emplace_back(station.station.positionM.head<2>());
        }
    }
    if (result.placed.empty() && !found.photos.empty()) {
        result.trouble = text("Of the last photo: ", found.places.photos.back().why);
        return result;
    }
    if (!store.plan().placements.empty()) {
        return result; // Its stations lie in the frame of its rails.
    }
    const FloorMotion motion = motionToShown(from, to);
    for (store::PlacedStation& place : places) {
        place.positionM.head<2>() = motion * place.positionM.head<2>();
        m_shown.insert(place.station);
    }
    Polygon outline = found.places.outline;
    for (Eigen::Vector2d& corner : outline) {
        corner = motion * corner;
    }
    store.placeStations(places);
    takeRoom(store, outline, found.places.ceilingM);
    return result;
}

} // namespace spherewalk::jobs
