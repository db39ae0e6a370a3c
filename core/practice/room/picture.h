// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "room/scene.h"

#include "spherewalk/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numbers>
#include <vector>

namespace spherewalk::practice {

/// The rays of an equirectangular picture. Frames: the room's corner.
class SphericalRays {
  public:
    SphericalRays(const Rigid3& roomFromPhoto, const EquirectSize& size);

    int width() const { return m_size.width; }

    int height() const { return m_size.height; }

    const Eigen::Vector3d& eye() const { return m_eye; }

    /// The angle that a pixel's side stands for.
    float pixelAngle(int /*x*/, int /*y*/) const { return m_pixelAngle; }

    /// The direction at eighth (i, j) of the pixel, (4, 4) being its centre; false where there is none.
    bool ray(int x, int y, int i, int j, Eigen::Vector3d& direction) const {
        const Turn& azimuth = m_azimuths[static_cast<std::size_t>(x)];
        const Turn& elevation = m_elevations[static_cast<std::size_t>(y)];
        const Turn& du = m_azimuthEighths[static_cast<std::size_t>(i)];
        const Turn& dv = m_elevationEighths[static_cast<std::size_t>(j)];
        const double cosAzimuth = azimuth.cosine * du.cosine - azimuth.sine * du.sine;
        const double sinAzimuth = azimuth.sine * du.cosine + azimuth.cosine * du.sine;
        const double cosElevation = elevation.cosine * dv.cosine - elevation.sine * dv.sine;
        const double sinElevation = elevation.sine * dv.cosine + elevation.cosine * dv.sine;
        direction = cosElevation * (cosAzimuth * m_forward + sinAzimuth * m_left) + sinElevation * m_up;
        return true;
    }

  private:
    struct Turn {
        double cosine;
        double sine;
    };

    static Turn turn(double angle) { return {std::cos(angle), std::sin(angle)}; }

    EquirectSize m_size;
    Eigen::Vector3d m_eye;
    Eigen::Vector3d m_forward;
    Eigen::Vector3d m_left;
    Eigen::Vector3d m_up;
    float m_pixelAngle;
    std::vector<Turn> m_azimuths;
    std::vector<Turn> m_elevations;
    std::vector<Turn> m_azimuthEighths;
    std::vector<Turn> m_elevationEighths;
};

/// The rays of a camera: exact at pixel centres, interpolated within pixels.
class ViewRays {
  public:
    ViewRays(const CameraModel& camera, const Rigid3& roomFromCamera, int threads);

    int width() const { return m_width; }

    int height() const { return m_height; }

    const Eigen::Vector3d& eye() const { return m_eye; }

    float pixelAngle(int x, int y) const { return m_angles[index(x, y)]; }

    bool ray(int x, int y, int i, int j, Eigen::Vector3d& direction) const {
        direction = m_rays[index(x, y)];
        if (i != 4 || j != 4) {
            direction += step(x, y, i < 4 ? -1 : 1, 0) * (std::abs(i - 4) / 8.0) +
                         step(x, y, 0, j < 4 ? -1 : 1) * (std::abs(j - 4) / 8.0);
            direction.normalize();
        }
        return m_angles[index(x, y)] > 0;
    }

    const Eigen::Vector3d& axis() const { return m_axis; }

  private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) + static_cast<std::size_t>(x);
    }

    /// From the pixel to its neighbour, or the opposite of that to the neighbour on the other side.
    Eigen::Vector3d step(int x, int y, int dx, int dy) const;
    float angleOf(int x, int y) const;

    int m_width;
    int m_height;
    Eigen::Vector3d m_eye;
    Eigen::Vector3d m_axis;
    std::vector<Eigen::Vector3d> m_rays; ///< zero where the camera has none
    std::vector<float> m_angles;         ///< zero where the camera has no ray
};

/// Draws pictures in three passes over tiles: one ray a pixel; which pixels hold an edge; more rays there.
template <class Rays>
class Picture {
  public:
    Picture(const Scene& scene, const Rays& rays, const PictureOptions& options, ProgressSink& progress,
            std::stop_token stop)
        : m_scene(scene), m_rays(rays), m_options(options), m_progress(progress), m_stop(std::move(stop)) {}

    RgbImage colours() {
        RgbImage picture(m_rays.width(), m_rays.height());
        Image<std::uint16_t, 1> ids(m_rays.width(), m_rays.height());
        overTiles(0, 0.5, [&](const Tile& tile) { firstPass(tile, picture, ids); });
        if (m_options.content == Content::Objects) {
            return picture; // a simulator's overlay: colour and depth of the same ray
        }
        Image<std::uint8_t, 1> extra(m_rays.width(), m_rays.height());
        parallelFor(picture.height(), kTile, m_options.threads, [&](int begin, int end) {
            for (int y = begin; y < end; ++y) {
                markEdges(y, picture, ids, extra);
            }
        });
        overTiles(0.5, 1, [&](const Tile& tile) { secondPass(tile, extra, picture); });
        return picture;
    }

    /// toDistance(direction): what the range is multiplied by.
    template <class Factor>
    DepthImage distances(Factor&& factor) {
        DepthImage depth(m_rays.width(), m_rays.height());
        overTiles(0, 1, [&](const Tile& tile) {
            forPixels(tile, [&](int x, int y) {
                Eigen::Vector3d direction;
                Hit hit;
                if (m_rays.ray(x, y, 4, 4, direction)) {
                    hit = m_scene.hit(m_rays.eye(), direction, tile.candidates, withWalls());
                }
                *depth.at(x, y) = static_cast<float>(hit.distance * factor(direction));
            });
        });
        return depth;
    }

  private:
    static constexpr int kTile = 32;

    struct Tile {
        int left, top, right, bottom;
        std::vector<Candidate> candidates;
        std::vector<Eigen::Vector3d> border;
    };

    bool withWalls() const { return m_options.content != Content::Objects; }

    template <class Body>
    static void forPixels(const Tile& tile, Body&& body) {
        for (int y = tile.top; y < tile.bottom; ++y) {
            for (int x = tile.left; x < tile.right; ++x) {
                body(x, y);
            }
        }
    }

    template <class Body>
    void overTiles(double progressBegin, double progressEnd, Body&& body) {
        int rowsDone = 0;
        const int rows = (m_rays.height() + kTile - 1) / kTile;
        parallelFor(rows, 1, m_options.threads, [&](int begin, int end) {
            Tile tile{};
            for (int row = begin; row < end; ++row) {
                throwIfStopped(m_stop);
                tile.top = row * kTile;
                tile.bottom = std::min(m_rays.height(), tile.top + kTile);
                for (tile.left = 0; tile.left < m_rays.width(); tile.left += kTile) {
                    tile.right = std::min(m_rays.width(), tile.left + kTile);
                    findCandidates(tile);
                    body(tile);
                }
                const std::scoped_lock lock(m_progressMutex);
                ++rowsDone;
                m_progress.progress(progressBegin + (progressEnd - progressBegin) * rowsDone / rows,
                                    "Drawing the practice room");
            }
        });
    }

    void findCandidates(Tile& tile) const {
        Eigen::Vector3d axis = Eigen::Vector3d::Zero();
        Eigen::Vector3d direction;
        tile.border.clear();
        const auto take = [&](int x, int y) {
            if (m_rays.ray(x, y, 4, 4, direction)) {
                tile.border.push_back(direction);
                axis += direction;
            }
        };
        for (int x = tile.left; x < tile.right; ++x) {
            take(x, tile.top);
            take(x, tile.bottom - 1);
        }
        for (int y = tile.top + 1; y + 1 < tile.bottom; ++y) {
            take(tile.left, y);
            take(tile.right - 1, y);
        }
        tile.candidates.clear();
        double halfAngle = 0;
        const double length = axis.norm();
        // Rays all around, or a lens whose field ends inside the tile: no cone holds them.
        const auto borderSize = 2 * (tile.right - tile.left) + 2 * std::max(0, tile.bottom - tile.top - 2);
        if (length < 0.5 * static_cast<double>(tile.border.size()) ||
            tile.border.size() < static_cast<std::size_t>(borderSize)) {
            axis = Eigen::Vector3d::UnitX();
            halfAngle = 4;
        } else {
            axis /= length;
            for (const Eigen::Vector3d& ray : tile.border) {
                halfAngle = std::max(halfAngle, std::atan2(ray.cross(axis).norm(), ray.dot(axis)));
            }
            halfAngle = 1.05 * halfAngle + 2 * m_rays.pixelAngle(tile.left, tile.top);
        }
        m_scene.candidates(m_rays.eye(), axis, halfAngle, m_options.content, tile.candidates);
    }

    static void store(const Rgb& colour, std::uint8_t* pixel) {
        for (int i = 0; i < 3; ++i) {
            pixel[i] = static_cast<std::uint8_t>(nearestInt(colour[i]));
        }
    }

    void firstPass(const Tile& tile, RgbImage& picture, Image<std::uint16_t, 1>& ids) const {
        forPixels(tile, [&](int x, int y) {
            Eigen::Vector3d direction;
            Hit hit;
            if (m_rays.ray(x, y, 4, 4, direction)) {
                hit = m_scene.hit(m_rays.eye(), direction, tile.candidates, withWalls());
            }
            *ids.at(x, y) = static_cast<std::uint16_t>(hit.id + 1);
            store(m_scene.colour(hit, m_rays.eye(), direction, m_rays.pixelAngle(x, y)), picture.at(x, y));
        });
    }

    /// extra: 0 for one ray, else the root of the number of rays.
    void markEdges(int y, const RgbImage& picture, const Image<std::uint16_t, 1>& ids,
                   Image<std::uint8_t, 1>& extra) const {
        constexpr int kContrast = 24;
        const int width = picture.width();
        for (int x = 0; x < width; ++x) {
            int contrast = 0;
            bool isEdge = false;
            for (const auto& [dx, dy] : {std::pair{-1, 0}, {1, 0}, {0, -1}, {0, 1}}) {
                const int nx = std::clamp(x + dx, 0, width - 1);
                const int ny = std::clamp(y + dy, 0, picture.height() - 1);
                isEdge = isEdge || *ids.at(nx, ny) != *ids.at(x, y);
                for (int i = 0; i < 3; ++i) {
                    contrast = std::max(contrast, std::abs(picture.at(nx, ny)[i] - picture.at(x, y)[i]));
                }
            }
            *extra.at(x, y) = isEdge && contrast > 40                            ? 4
                              : contrast > kContrast || (isEdge && contrast > 6) ? 2
                                                                                 : 0;
        }
    }

    void secondPass(const Tile& tile, const Image<std::uint8_t, 1>& extra, RgbImage& picture) const {
        forPixels(tile, [&](int x, int y) {
            const int side = *extra.at(x, y);
            if (side == 0) {
                return;
            }
            const int stride = 8 / side;
            const float angle = m_rays.pixelAngle(x, y) / static_cast<float>(side);
            Rgb sum = Rgb::Zero();
            for (int j = stride / 2; j < 8; j += stride) {
                for (int i = stride / 2; i < 8; i += stride) {
                    Eigen::Vector3d direction;
                    if (m_rays.ray(x, y, i, j, direction)) {
                        const Hit hit = m_scene.hit(m_rays.eye(), direction, tile.candidates, withWalls());
                        sum += m_scene.colour(hit, m_rays.eye(), direction, angle);
                    }
                }
            }
            store(sum / static_cast<float>(side * side), picture.at(x, y));
        });
    }

    const Scene& m_scene;
    const Rays& m_rays;
    PictureOptions m_options;
    ProgressSink& m_progress;
    std::stop_token m_stop;
    std::mutex m_progressMutex;
};

} // namespace spherewalk::practice
