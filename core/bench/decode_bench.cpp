// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_photo.h"
#include "contest.h"
#include "measurements.h"
#include "sphere/exact_view.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace spherewalk::bench {

using jpeg::PixelRect;

namespace {

constexpr int kMcu = 16;
constexpr int kStep = 8; // A view is sampled every so many pixels.
constexpr int kReducedBy = 2;

std::uint64_t pixelBytes(const RgbImage& picture) {
    return picture.values().size();
}

std::uint64_t pixelBytes(const jpeg::Planes& planes) {
    return planes.luma.values().size() + planes.blue.values().size() + planes.red.values().size();
}

class DecodeBench {
  public:
    DecodeBench(const BenchPhoto& photo, bool peers)
        : m_photo(photo), m_threads(std::min(2, hardwareThreads())) {
        const render::DatasetPhoto& entry = photo.entry();
        const std::filesystem::path& folder = photo.dataset().folder();
        if (entry.restartIndex.empty()) {
            add("decode.whole", 1, [this] { return pixelBytes(wholeByLibjpeg()); });
        } else {
            const auto indexFile = folder / entry.restartIndex;
            m_decoder.emplace(std::make_shared<MemorySource>(photo.jpeg(), entry.file),
                              jpeg::parseRestartIndex(readFile(indexFile), indexFile.string()));
            m_region = regionAhead(standardCamera(90), {entry.width, entry.height});
            addParts();
        }
        if (!entry.thumbnail.empty()) {
            const Bytes thumbnail = readFile(folder / entry.thumbnail);
            add("decode.thumbnail", 1,
                [=] { return pixelBytes(jpeg::decode(thumbnail, "the photo's thumbnail")); });
        }
        if (peers && m_decoder) {
            m_contest.add(kLibjpegWhole, [this](int) { wholeByLibjpeg(); });
            m_hasPeer = true;
        }
    }

    void verify(const std::stop_token& stop) const {
        if (!m_decoder) {
            return;
        }
        requirePart(m_decoder->decode(m_region), m_region, m_photo.picture(), "a decoded region");
        requirePart(m_decoder->decode(whole(), {.threads = 0, .stop = stop}), whole(), m_photo.picture(),
                    "the photo decoded by several threads");
        throwIfStopped(stop);
        const PixelRect reduced = reducedRegion();
        requirePart(m_decoder->decode(reduced, {.denominator = kReducedBy, .stop = stop}), reduced,
                    jpeg::decode(m_photo.jpeg(), m_photo.entry().file, kReducedBy), "a reduced region");
        throwIfStopped(stop);
        if (m_hasPlanes) {
            requirePart(m_decoder->decodePlanes(m_region), m_region, m_decoder->decodePlanes(whole(), 0),
                        "a region's planes");
        }
    }

    std::vector<BenchRow> run(int rounds, ProgressSink& progress, const std::stop_token& stop) {
        m_contest.run(rounds, 1, progress, "Timing decoding", stop);
        for (BenchRow& row : m_rows) {
            row.own = m_contest.of(entryName(row.name, row.threads));
            if (m_hasPeer && (row.name == "decode.whole" || row.name == "decode.region")) {
                row.peer = {kLibjpegWhole, m_contest.of(kLibjpegWhole).medianMs};
            }
        }
        return m_rows;
    }

  private:
    /// Decodes once and returns the bytes of what came out.
    using Decode = std::function<std::uint64_t()>;

    static std::string entryName(const std::string& row, int threads) { return text(row, " ", threads); }

    void add(const std::string& name, int threads, const Decode& decode) {
        BenchRow row;
        row.name = name;
        row.threads = threads;
        row.bytes = decode();
        m_rows.push_back(row);
        m_contest.add(entryName(name, threads), [decode](int) { decode(); });
    }

    void addPlanes(const std::string& name, const PixelRect& region, int threads) {
        try {
            add(name, threads, [=, this] { return pixelBytes(m_decoder->decodePlanes(region, threads)); });
            m_hasPlanes = true;
        } catch (const Error& error) { // chroma that is stored in an unusual way has no such row
            if (error.kind() != ErrorKind::Unsupported) {
                throw;
            }
        }
    }

    void addParts() {
        const auto addPictures = [this](const std::string& name, const PixelRect& region, int denominator) {
            for (int threads = 1; threads <= m_threads; ++threads) {
                add(name, threads, [=, this] {
                    return pixelBytes(m_decoder->decode(
                        region, {.denominator = denominator, .threads = threads, .stop = {}}));
                });
            }
        };
        addPictures("decode.whole", whole(), 1);
        addPictures("decode.region", m_region, 1);
        addPictures("decode.reduced", reducedRegion(), kReducedBy);
        for (int threads = 1; threads <= m_threads; ++threads) {
            addPlanes("decode.whole.planes", whole(), threads);
            addPlanes("decode.region.planes", m_region, threads);
        }
    }

    PixelRect whole() const { return {0, 0, m_decoder->width(), m_decoder->height()}; }

    PixelRect reducedRegion() const {
        return {m_region.x / kReducedBy, m_region.y / kReducedBy, m_region.width / kReducedBy,
                m_region.height / kReducedBy};
    }

    RgbImage wholeByLibjpeg() const { return jpeg::decode(m_photo.jpeg(), m_photo.entry().file); }

    const BenchPhoto& m_photo;
    int m_threads;
    std::optional<jpeg::RegionDecoder> m_decoder;
    PixelRect m_region;
    Contest m_contest;
    std::vector<BenchRow> m_rows;
    bool m_hasPeer = false;
    bool m_hasPlanes = false;
};

} // namespace

PixelRect regionAhead(const CameraModel& camera, const EquirectSize& photo) {
    const render::Projection projection(camera, lookingTo(0, 0), {}, photo, render::SceneKind::None, 1);
    Eigen::Vector2d least(photo.width, photo.height);
    Eigen::Vector2d greatest(0, 0);
    for (int y = 0; y <= camera.height(); y += kStep) {
        for (int x = 0; x <= camera.width(); x += kStep) {
            const Eigen::Vector2d pixel = *projection.photoPixel(Eigen::Vector2d(x - 0.5, y - 0.5));
            least = least.cwiseMin(pixel);
            greatest = greatest.cwiseMax(pixel);
        }
    }
    const auto begin = [](double value) { return std::max(0, static_cast<int>(value) / kMcu * kMcu); };
    const auto end = [](double value, int most) {
        return std::min(most, (static_cast<int>(std::ceil(value)) / kMcu + 1) * kMcu);
    };
    const int left = begin(least.x());
    const int top = begin(least.y());
    return {left, top, end(greatest.x(), photo.width) - left, end(greatest.y(), photo.height) - top};
}

std::vector<BenchRow> measureDecoding(const BenchPhoto& photo, bool peers, int rounds, ProgressSink& progress,
                                      const std::stop_token& stop) {
    DecodeBench decoding(photo, peers);
    decoding.verify(stop);
    return decoding.run(rounds, progress, stop);
}

} // namespace spherewalk::bench
