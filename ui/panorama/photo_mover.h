// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/panorama/region_tool.h"
#include "ui/tasks/background_worker.h"

#include "spherewalk/geometry/angle.h"
#include "spherewalk/geometry/rigid3.h"
#include "spherewalk/render/panorama.h"
#include "spherewalk/render/scene_depth.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace spherewalk::ui {

/// An area of a photo that somebody must look at. Frames: the photo's panorama frame.
struct PhotoArea {
    Radians azimuth; ///< Of the middle, counter-clockwise from the picture's middle.
    Radians elevation;
    Radians halfWidth;
    Radians halfHeight;

    bool operator==(const PhotoArea& other) const = default;
};

/// A photo that the viewer shows.
struct ShownPhoto {
    std::filesystem::path file;
    QString name; ///< Station and file, for people.
    Rigid3 roomFromPhoto;
    bool isAligned = true; ///< Whether the rotation of roomFromPhoto is known.
    std::vector<PhotoArea> areas = {};
    std::vector<ShownRegion> regions = {};
    std::filesystem::path depthFile = {}; ///< A file of render::DepthMap; empty if no depth is known.

    bool operator==(const ShownPhoto& other) const {
        return file == other.file && name == other.name && isAligned == other.isAligned &&
               areas == other.areas && regions == other.regions && depthFile == other.depthFile &&
               roomFromPhoto.rotation.coeffs() == other.roomFromPhoto.rotation.coeffs() &&
               roomFromPhoto.translation == other.roomFromPhoto.translation;
    }
};

/// What stands for the surroundings of photos whose depth is not known.
struct Surroundings {
    std::optional<render::RoomShape> room; ///< Walls, floor and ceiling as somebody drew them.
    std::optional<double> sphereRadiusM;   ///< The radius of a sphere, where there is no room.

    bool operator==(const Surroundings&) const = default;
};

/// What told how far away things are when a photo was moved, from the best on.
enum class MovedBy { Depth, Room, Sphere, Turn };

/// Moves one photo to the place of another one, in the background: first small, then in full. Photos that are
/// not aligned are turned by what both show. Where that tells nothing, the photo is not shown at all, since
/// photos that are turned differently cannot be compared. Threads: the GUI thread.
class PhotoMover : public QObject {
    Q_OBJECT

  public:
    struct Picture {
        render::Panorama panorama; ///< In the frame of the photo at whose place it is.
        MovedBy by = MovedBy::Turn;
    };

    explicit PhotoMover(QObject* parent = nullptr) : QObject(parent) {}

    /// Asks for `there` as seen from `here`. The same wish again changes nothing.
    void want(const ShownPhoto& here, const ShownPhoto& there, const Surroundings& surroundings);

    /// Returns the wanted picture; nothing before it is there.
    const std::optional<Picture>& picture() const { return m_picture; }

    /// Says why there is none; empty otherwise.
    QString sentence() const { return m_sentence; }

  signals:
    void moved();

  private:
    struct Wish {
        ShownPhoto here;
        ShownPhoto there;
        Surroundings surroundings;

        bool operator==(const Wish&) const = default;
    };

    void post(const Wish& wish, int denominator);
    static Picture made(Wish wish, int denominator);

    std::optional<Wish> m_wish;
    std::optional<Picture> m_picture;
    QString m_sentence;
    BackgroundWorker m_worker; ///< The last member, as its results use the others.
};

} // namespace spherewalk::ui
