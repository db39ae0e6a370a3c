// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/place/fusion.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace spherewalk::place {

namespace {

constexpr int kKeyBits = 21;
constexpr std::int64_t kKeyBias = 1 << (kKeyBits - 1); ///< blocks to either side of the origin
constexpr std::uint64_t kMostBytes = 4ULL << 30U;
constexpr int kBlocksAGrain = 16;
constexpr float kEdgeWeight = 0.03F; ///< of a vote where a photo's pixels show different things

int blockCoordinate(int voxel) {
    return voxel >= 0 ? voxel / Volume::kSide : -((Volume::kSide - 1 - voxel) / Volume::kSide);
}

std::uint64_t keyOf(const Eigen::Vector3i& block) {
    std::uint64_t key = 0;
    for (int axis = 2; axis >= 0; --axis) {
        key = key << static_cast<unsigned>(kKeyBits) | static_cast<std::uint64_t>(block[axis] + kKeyBias);
    }
    return key;
}

Eigen::Vector3i blockOfKey(std::uint64_t key) {
    constexpr std::uint64_t kMask = (1ULL << static_cast<unsigned>(kKeyBits)) - 1;
    Eigen::Vector3i block;
    for (int axis = 0; axis < 3; ++axis) {
        block[axis] = static_cast<int>(static_cast<std::int64_t>(key & kMask) - kKeyBias);
        key >>= static_cast<unsigned>(kKeyBits);
    }
    return block;
}

/// What a photo says about a voxel.
struct Vote {
    float distanceM;
    float weight;
};

/// The vote at which half of the weight is reached. The function reorders the votes.
float weightedMedian(std::vector<Vote>& votes, float weight) {
    std::sort(votes.begin(), votes.end(),
              [](const Vote& a, const Vote& b) { return a.distanceM < b.distanceM; });
    float reached = 0;
    for (const Vote& vote : votes) {
        reached += vote.weight;
        if (2 * reached >= weight) {
            return vote.distanceM;
        }
    }
    return votes.back().distanceM;
}

} // namespace

void FusionOptions::validate() const {
    if (!(voxelM >= 0.002 && voxelM <= 1)) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not fuse depths: a voxel must be 0.002 to 1 m large, not ", voxelM, " m."));
    }
}

Eigen::Vector3i Volume::corner(std::size_t block) const {
    return kSide * blockOfKey(m_keys[block]);
}

std::size_t Volume::blockOf(const Eigen::Vector3i& voxel) const {
    const std::uint64_t key = keyOf(voxel.unaryExpr(&blockCoordinate));
    const auto found = std::lower_bound(m_keys.begin(), m_keys.end(), key);
    return found != m_keys.end() && *found == key ? static_cast<std::size_t>(found - m_keys.begin())
                                                  : m_blocks.size();
}

Eigen::Vector3i Volume::nearest(const Eigen::Vector3d& pInRoom) const {
    return ((pInRoom - m_originM) / m_voxelM).array().round().matrix().cast<int>();
}

class Fusion {
  public:
    Fusion(std::span<const SeenDepth> photos, const FusionOptions& options, ProgressSink& progress,
           const std::stop_token& stop)
        : m_photos(photos),
          m_options(options),
          m_truncationM(static_cast<float>(options.truncationM())),
          m_progress(progress),
          m_stop(stop) {
        m_volume.m_voxelM = options.voxelM;
        // Whole voxels, so that rooms with the same photos and another origin have the same surface.
        m_volume.m_originM =
            ((photos.front().roomFromPhoto().translation / options.voxelM).array().round() * options.voxelM)
                .matrix();
    }

    Volume run() {
        requireInReach();
        allocate();
        const auto count = static_cast<int>(m_volume.m_blocks.size());
        parallelFor(count, kBlocksAGrain, m_options.threads, [&](int begin, int end) {
            throwIfStopped(m_stop);
            std::vector<Vote> votes;
            for (int i = begin; i < end; ++i) {
                fill(static_cast<std::size_t>(i), votes);
            }
            tell(end - begin, count);
        });
        return std::move(m_volume);
    }

  private:
    /// Half of the reach is left for what photos show.
    void requireInReach() const {
        const double mostM = static_cast<double>(kKeyBias) / 2 * Volume::kSide * m_options.voxelM;
        for (const SeenDepth& photo : m_photos) {
            const double aside =
                (photo.roomFromPhoto().translation - m_volume.m_originM).cwiseAbs().maxCoeff();
            if (!(aside <= mostM)) {
                throw Error(ErrorKind::InvalidInput, text("Could not fuse depths: a photo stands ", aside,
                                                          " m away from the first, and with voxels of ",
                                                          m_options.voxelM, " m ", mostM, " m is the most."));
            }
        }
    }

    bool isUsable(const SeenDepth& photo, float rangeM) const {
        return rangeM > 0 && photo.sigmaM(rangeM) <= m_truncationM;
    }

    /// Blocks in which a photo shows a surface, or that lie within the truncation of one.
    std::vector<std::uint64_t> keysOf(const SeenDepth& photo) const {
        constexpr int kStride = 2; // of pixels: neighbours are much nearer than a block is long
        std::vector<std::uint64_t> keys;
        for (int y = 0; y < photo.height(); y += kStride) {
            for (int x = 0; x < photo.width(); x += kStride) {
                const float range = photo.rangeM(x, y);
                if (!isUsable(photo, range)) {
                    continue;
                }
                for (const float d : {-m_truncationM, 0.0F, m_truncationM}) {
                    const Eigen::Vector3i voxel = m_volume.nearest(photo.point(x, y, range + d));
                    const std::uint64_t key = keyOf(voxel.unaryExpr(&blockCoordinate));
                    if (keys.empty() || keys.back() != key) {
                        keys.push_back(key);
                    }
                }
            }
        }
        std::sort(keys.begin(), keys.end());
        keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
        return keys;
    }

    void allocate() {
        const auto count = static_cast<int>(m_photos.size());
        std::vector<std::vector<std::uint64_t>> keys(m_photos.size());
        parallelFor(count, 1, m_options.threads, [&](int begin, int) {
            throwIfStopped(m_stop);
            keys[static_cast<std::size_t>(begin)] = keysOf(m_photos[static_cast<std::size_t>(begin)]);
        });
        std::vector<std::uint64_t>& all = m_volume.m_keys;
        for (const std::vector<std::uint64_t>& some : keys) {
            std::vector<std::uint64_t> both;
            std::set_union(all.begin(), all.end(), some.begin(), some.end(), std::back_inserter(both));
            all = std::move(both);
        }
        if (all.size() * sizeof(Volume::Block) > kMostBytes) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not fuse depths: with voxels of ", m_options.voxelM, " m they take ",
                             humanBytes(all.size() * sizeof(Volume::Block)), ", and ", humanBytes(kMostBytes),
                             " is the most. Take larger voxels."));
        }
        m_volume.m_blocks.resize(all.size());
    }

    void fill(std::size_t block, std::vector<Vote>& votes) {
        const Eigen::Vector3i corner = m_volume.corner(block);
        std::size_t i = 0;
        for (int z = 0; z < Volume::kSide; ++z) {
            for (int y = 0; y < Volume::kSide; ++y) {
                for (int x = 0; x < Volume::kSide; ++x) {
                    const Eigen::Vector3d at =
                        m_volume.m_originM +
                        m_volume.m_voxelM * (corner + Eigen::Vector3i(x, y, z)).cast<double>();
                    m_volume.m_blocks[block][i++] = voxelAt(at, votes);
                }
            }
        }
    }

    Voxel voxelAt(const Eigen::Vector3d& pInRoom, std::vector<Vote>& votes) const {
        votes.clear();
        Voxel voxel;
        for (const SeenDepth& photo : m_photos) {
            const Sight sight = photo.sight(pInRoom);
            const float distance = sight.rangeM - sight.pointM;
            if (!sight.isSure || distance < -m_truncationM || !isUsable(photo, sight.rangeM)) {
                continue;
            }
            const Vote vote = voteOf(photo, sight);
            votes.push_back(vote);
            voxel.weight += vote.weight;
        }
        if (voxel.weight > 0) {
            voxel.distanceM = consensus(votes, voxel.weight);
        }
        return voxel;
    }

    /// Behind a surface a vote counts less, because a thin thing has another side there.
    Vote voteOf(const SeenDepth& photo, const Sight& sight) const {
        constexpr float kReferenceM = 0.01F;
        const float sigma = photo.sigmaM(sight.rangeM) / kReferenceM;
        const float distance = std::min(sight.rangeM - sight.pointM, m_truncationM);
        const float behind = std::max(-distance / m_truncationM, 0.0F);
        return {distance, (sight.isEdge ? kEdgeWeight : 1.0F) * (1 - behind) / (sigma * sigma)};
    }

    float consensus(std::vector<Vote>& votes, float weight) const {
        const float median = weightedMedian(votes, weight);
        float sum = 0;
        float about = 0;
        for (const Vote& vote : votes) {
            if (std::abs(vote.distanceM - median) <= m_truncationM / 3) {
                sum += vote.weight * vote.distanceM;
                about += vote.weight;
            }
        }
        return about > 0 ? sum / about : median;
    }

    void tell(int more, int count) {
        const std::scoped_lock lock(m_mutex);
        m_done += more;
        m_progress.progress(static_cast<double>(m_done) / count, "Fusing depths");
    }

    std::span<const SeenDepth> m_photos;
    const FusionOptions& m_options;
    float m_truncationM;
    ProgressSink& m_progress;
    std::stop_token m_stop;
    std::mutex m_mutex;
    int m_done = 0;
    Volume m_volume;
};

Volume fused(std::span<const SeenDepth> photos, const FusionOptions& options, ProgressSink& progress,
             const std::stop_token& stop) {
    options.validate();
    if (photos.empty()) {
        throw Error(ErrorKind::InvalidInput, "Could not fuse depths: no photo has a depth.");
    }
    return Fusion(photos, options, progress, stop).run();
}

} // namespace spherewalk::place
