// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "temporary_folder.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/store/survey_store.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <vector>

namespace spherewalk::test {

/// A survey in a folder of its own whose first stations have photos with known rotations: an endlessly far
/// world that differs in every direction, a little brighter in each photo: red grows along x, green along y,
/// blue upwards.
class PhotographedSurvey {
  public:
    /// stations: the plan has at least so many.
    explicit PhotographedSurvey(int photos = 4, int width = 512, int stations = 0)
        : m_path(m_folder / "room.spherewalk") {
        survey::Room room;
        room.outline = {{0, 0}, {4, 0}, {4, 3}, {0, 3}};
        room.ceilingM = 2.5;
        survey::PlanOptions options;
        options.stepM = 1;
        while (static_cast<int>(survey::plan(room, options).stations.size()) < std::max(photos, stations)) {
            options.stepM *= 0.8;
        }
        auto store = store::SurveyStore::create(m_path, "room", room, options, survey::plan(room, options));
        const std::vector<store::StationRecord> planned = store.stations();
        std::filesystem::create_directories(m_folder / "in");
        std::string csv = "file,x_m,y_m,z_m,yaw_deg\n";
        std::vector<RgbImage> shades;
        for (int i = 0; i < std::min(photos, kShades); ++i) {
            shades.push_back(world(width, 4 * i));
        }
        for (int i = 0; i < photos; ++i) {
            const std::string name = text("R", 1001 + i, ".JPG");
            const Eigen::Vector3d& at = planned.at(static_cast<std::size_t>(i)).station.positionM;
            writeFile(m_folder / "in" / name,
                      jpeg::encode(shades[static_cast<std::size_t>(i % kShades)], 90 - i / kShades));
            csv += text(name, ",", fixed(at.x(), 4), ",", fixed(at.y(), 4), ",", fixed(at.z(), 4), ",0\n");
        }
        writeFile(m_folder / "p.csv", bytesOf(csv));
        jobs::importPhotos(store, {m_folder / "in", m_folder / "p.csv"}, noProgress(), {});
    }

    const std::filesystem::path& path() const { return m_path; }

    std::filesystem::path operator/(const std::filesystem::path& name) const { return m_folder / name; }

    void leaveUnchecked() { m_folder.leaveUnchecked(); }

    store::SurveyStore open(store::Access access = store::Access::Read) const {
        return store::SurveyStore::open(m_path, access);
    }

  private:
    static constexpr int kShades = 24; ///< then they repeat, and the quality differs

    static RgbImage world(int width, int brighter) {
        RgbImage picture(width, width / 2);
        const EquirectSize size{width, width / 2};
        for (int v = 0; v < size.height; ++v) {
            for (int u = 0; u < size.width; ++u) {
                const Eigen::Vector3d d = direction(size, Eigen::Vector2d(u, v));
                const Eigen::Vector3d colour = Eigen::Vector3d(110, 110, 110) + 60 * d;
                for (int c = 0; c < 3; ++c) {
                    picture.at(u, v)[c] =
                        static_cast<std::uint8_t>(std::clamp(colour[c] + speckle(d) + brighter, 0.0, 255.0));
                }
            }
        }
        return picture;
    }

    /// Patches of about 4 degrees with a grey of their own: corners that an alignment recognises.
    static double speckle(const Eigen::Vector3d& direction) {
        std::uint32_t hash = 2166136261U;
        for (const double coordinate : direction) {
            hash = (hash ^ static_cast<std::uint32_t>(std::lround(14 * coordinate) + 100)) * 16777619U;
        }
        return static_cast<double>((hash >> 16U) % 60U);
    }

    TemporaryFolder m_folder;
    std::filesystem::path m_path;
};

} // namespace spherewalk::test
