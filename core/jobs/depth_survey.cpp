// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/jobs/depth_survey.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/render/depth_map.h"
#include "spherewalk/scene/room_fit.h"

#include <algorithm>
#include <chrono>
#include <list>
#include <memory>

namespace spherewalk::jobs {

namespace {

constexpr int kMethod = 1; ///< grows when the same photos and options give another depth
constexpr std::uint64_t kLargestFile = 128ULL << 20;
constexpr std::size_t kPicturesKept = 24;
constexpr std::size_t kPhotosForScene = 12; ///< that radius and room are estimated from

/// What was made last, by photo.
template <class Value>
class Kept {
  public:
    template <class Make>
    std::shared_ptr<const Value> get(std::size_t photo, Make&& make) {
        const auto found = std::find_if(m_values.begin(), m_values.end(),
                                        [&](const auto& entry) { return entry.first == photo; });
        if (found != m_values.end()) {
            m_values.splice(m_values.begin(), m_values, found);
        } else {
            m_values.emplace_front(photo, std::make_shared<const Value>(make()));
            m_values.resize(std::min(m_values.size(), kPicturesKept));
        }
        return m_values.front().second;
    }

  private:
    std::list<std::pair<std::size_t, std::shared_ptr<const Value>>> m_values;
};

scene::PhotoDepth depthOf(const render::DepthMap& map) {
    return {map.inverseM(), map.sure()};
}

std::string poseText(const Rigid3& pose) {
    const Eigen::Quaterniond& q = pose.rotation;
    const Eigen::Vector3d& t = pose.translation;
    return text(q.w(), " ", q.x(), " ", q.y(), " ", q.z(), " ", t.x(), " ", t.y(), " ", t.z());
}

class DepthJob {
  public:
    DepthJob(std::span<const DepthInput> photos, const DepthOptions& options, ProgressSink& progress,
             const std::stop_token& stop)
        : m_photos(photos), m_options(options), m_progress(progress), m_stop(stop) {
        options.sweep.validate();
        for (const DepthInput& photo : photos) {
            m_poses.push_back(photo.roomFromPhoto);
        }
        for (std::size_t i = 0; i < photos.size(); ++i) {
            m_neighbours.push_back(scene::sweepNeighbours(m_poses, i, options.sweep));
        }
        std::error_code failure;
        std::filesystem::create_directories(options.cacheFolder, failure);
        if (failure) {
            throw Error(ErrorKind::Io, text("Could not make the folder ", options.cacheFolder.string(), ": ",
                                            failure.message(), "."));
        }
    }

    SurveyDepth run() {
        const auto begin = std::chrono::steady_clock::now();
        SurveyDepth result;
        result.files.resize(m_photos.size());
        for (std::size_t i = 0; i < m_photos.size(); ++i) {
            throwIfStopped(m_stop);
            if (m_neighbours[i].empty()) {
                continue;
            }
            result.files[i] = fileOf(agreedKey(i));
            ++result.report.photos;
            if (isThere(result.files[i])) {
                ++result.report.reused;
            } else {
                keep(result.files[i], agreed(i));
            }
            m_progress.progress(static_cast<double>(i + 1) / static_cast<double>(m_photos.size()),
                                text("Estimating depth, photo ", i + 1, " of ", m_photos.size()));
        }
        result.radiusM = radius(result);
        result.report.seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        return result;
    }

  private:
    /// All that a photo's own depth depends on.
    std::string sweptKey(std::size_t photo) const {
        const scene::SweepOptions& o = m_options.sweep;
        std::string key = text("sweep ", kMethod, " ", o.width, " ", o.coarseWidth, " ", o.distances, " ",
                               o.nearestM, " ", o.farthestM, " ", o.keptShare, "\n", m_photos[photo].sha256,
                               " ", poseText(m_poses[photo]), "\n");
        for (const std::size_t other : m_neighbours[photo]) {
            key += text(m_photos[other].sha256, " ", poseText(m_poses[other]), "\n");
        }
        return sha256Hex(bytesOf(key));
    }

    std::span<const std::size_t> agreeing(std::size_t photo) const {
        const std::vector<std::size_t>& all = m_neighbours[photo];
        return {all.data(), std::min(all.size(), static_cast<std::size_t>(m_options.agreeing))};
    }

    std::string agreedKey(std::size_t photo) const {
        std::string key = "agreed " + sweptKey(photo);
        for (const std::size_t other : agreeing(photo)) {
            key += " " + sweptKey(other);
        }
        return sha256Hex(bytesOf(key));
    }

    std::filesystem::path fileOf(const std::string& key) const {
        return m_options.cacheFolder / (key.substr(0, 32) + ".pgm");
    }

    /// Files are written under another name and renamed: those that are there are whole.
    static bool isThere(const std::filesystem::path& file) { return std::filesystem::is_regular_file(file); }

    static void keep(const std::filesystem::path& file, const scene::PhotoDepth& depth) {
        writeFile(file, render::DepthMap(depth.inverseM, depth.sure).serialised());
    }

    static scene::PhotoDepth kept(const std::filesystem::path& file) {
        return depthOf(render::DepthMap::parse(readFile(file, kLargestFile), file.string()));
    }

    std::shared_ptr<const RgbImage> picture(std::size_t photo) {
        return m_pictures.get(photo, [&] {
            const std::string name = m_photos[photo].file.string();
            const Bytes bytes = readFile(m_photos[photo].file);
            const int width = jpeg::readInfo(bytes, name).width;
            int denominator = 1;
            while (denominator < 8 && width / (2 * denominator) >= 2 * m_options.sweep.width) {
                denominator *= 2;
            }
            return jpeg::decode(bytes, name, denominator);
        });
    }

    std::shared_ptr<const scene::PhotoDepth> swept(std::size_t photo) {
        return m_swept.get(photo, [&] {
            const std::filesystem::path file = fileOf(sweptKey(photo));
            if (isThere(file)) {
                return kept(file);
            }
            std::vector<std::shared_ptr<const RgbImage>> pictures;
            std::vector<scene::PosedPicture> neighbours;
            for (const std::size_t other : m_neighbours[photo]) {
                pictures.push_back(picture(other));
                neighbours.push_back({pictures.back().get(), m_poses[other]});
            }
            const auto own = picture(photo);
            keep(file, scene::sweptDepth({own.get(), m_poses[photo]}, neighbours, m_options.sweep, m_stop));
            return kept(file); // rounded as a later run will find it
        });
    }

    scene::PhotoDepth agreed(std::size_t photo) {
        std::vector<std::shared_ptr<const scene::PhotoDepth>> depths;
        std::vector<scene::PosedDepth> neighbours;
        for (const std::size_t other : agreeing(photo)) {
            depths.push_back(swept(other));
            neighbours.push_back({depths.back().get(), m_poses[other]});
        }
        const auto own = swept(photo);
        return scene::agreeingDepth({own.get(), m_poses[photo]}, *picture(photo), neighbours,
                                    m_options.sweep.threads);
    }

    std::optional<double> radius(const SurveyDepth& found) const {
        std::vector<scene::PhotoDepth> depths;
        std::vector<scene::PosedDepth> posed;
        for (const std::size_t i : spread(found)) {
            depths.push_back(kept(found.files[i]));
        }
        for (const scene::PhotoDepth& depth : depths) {
            posed.push_back({&depth, {}});
        }
        return scene::sphereRadius(posed);
    }

  public:
    /// Some of the photos that have a depth.
    static std::vector<std::size_t> spread(const SurveyDepth& found) {
        std::vector<std::size_t> all;
        for (std::size_t i = 0; i < found.files.size(); ++i) {
            if (!found.files[i].empty()) {
                all.push_back(i);
            }
        }
        std::vector<std::size_t> some;
        const std::size_t count = std::min(all.size(), kPhotosForScene);
        for (std::size_t k = 0; k < count; ++k) {
            some.push_back(all[k * all.size() / count]);
        }
        return some;
    }

    static scene::PhotoDepth load(const std::filesystem::path& file) { return kept(file); }

  private:
    std::span<const DepthInput> m_photos;
    const DepthOptions& m_options;
    ProgressSink& m_progress;
    std::stop_token m_stop;
    std::vector<Rigid3> m_poses;
    std::vector<std::vector<std::size_t>> m_neighbours;
    Kept<RgbImage> m_pictures;
    Kept<scene::PhotoDepth> m_swept;
};

} // namespace

SurveyDepth surveyDepth(std::span<const DepthInput> photos, const DepthOptions& options,
                        ProgressSink& progress, const std::stop_token& stop) {
    return DepthJob(photos, options, progress, stop).run();
}

std::optional<render::RoomShape> fittedRoom(std::span<const DepthInput> photos, const SurveyDepth& depth,
                                            const Polygon& drawnOutline) {
    const std::vector<std::size_t> some = DepthJob::spread(depth);
    if (some.empty()) {
        return std::nullopt;
    }
    std::vector<scene::PhotoDepth> depths;
    for (const std::size_t i : some) {
        depths.push_back(DepthJob::load(depth.files[i]));
    }
    std::vector<scene::PosedDepth> posed;
    for (std::size_t k = 0; k < some.size(); ++k) {
        posed.push_back({&depths[k], photos[some[k]].roomFromPhoto});
    }
    return scene::fittedRoom(posed, drawnOutline);
}

} // namespace spherewalk::jobs
