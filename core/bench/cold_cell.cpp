// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_photo.h"
#include "contest.h"
#include "measurements.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace spherewalk::bench {

using render::VerifyPhotos;
using SteadyClock = std::chrono::steady_clock;

namespace {

class Descriptor {
  public:
    explicit Descriptor(const std::filesystem::path& file)
        : m_number(::open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
        if (m_number < 0) {
            throw Error(errno == ENOENT ? ErrorKind::NotFound : ErrorKind::Io,
                        text("Could not open ", file.string(), ": ", std::strerror(errno), "."));
        }
    }

    ~Descriptor() { ::close(m_number); }

    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return m_number; }

  private:
    int m_number;
};

/// Whether any page of the file is in memory; true if the system does not say.
bool isCached(const Descriptor& file) {
    struct stat status {};

    if (::fstat(file.number(), &status) != 0 || status.st_size == 0) {
        return true;
    }
    const auto size = static_cast<std::size_t>(status.st_size);
    void* mapped = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, file.number(), 0);
    if (mapped == MAP_FAILED) {
        return true;
    }
    const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    std::vector<unsigned char> pages((size + page - 1) / page);
    const bool isTold = ::mincore(mapped, size, pages.data()) == 0;
    ::munmap(mapped, size);
    return !isTold || std::any_of(pages.begin(), pages.end(), [](unsigned char p) { return (p & 1) != 0; });
}

/// Those that are the nearest one to their own place.
std::vector<std::size_t> photosWithCell(const render::Dataset& dataset) {
    std::vector<std::size_t> photos;
    for (std::size_t i = 0; i < dataset.info().photos.size(); ++i) {
        if (dataset.nearestPhoto(dataset.info().photos[i].roomFromPhoto.translation) == i) {
            photos.push_back(i);
        }
    }
    return photos;
}

class ColdCell {
  public:
    /// Where the file is when the view is asked for.
    enum class From { SystemCache, Disk };

    ColdCell(const std::shared_ptr<const render::Dataset>& dataset, VerifyPhotos verify, From from)
        : m_dataset(dataset),
          m_verify(verify),
          m_from(from),
          m_photos(photosWithCell(*dataset)),
          m_warm(dataset) {
        renderFrom(m_warm, m_photos.front(), 0);
    }

    void measureOne(int turn) {
        const std::size_t photo = next();
        prepare(photo);
        auto begin = SteadyClock::now();
        renderFrom(*m_cold, photo, turn);
        m_ownMs.push_back(millisecondsSince(begin));
        m_parts.add(m_view.report);
        prepare(photo);
        begin = SteadyClock::now();
        wholeAndRender(photo, turn);
        m_peerMs.push_back(millisecondsSince(begin));
    }

    BenchRow row(const std::string& name) const {
        BenchRow row;
        row.name = name;
        row.threads = hardwareThreads();
        row.own = measured(m_ownMs);
        row.peer = {kWholeAndRender, measured(m_peerMs).medianMs};
        row.view = ViewSetting{};
        row.parts = m_parts.median();
        return row;
    }

    bool filesDropped() const { return m_filesDropped; }

  private:
    /// A photo that the cold renderer has not seen. The first one of a new renderer only makes the camera's
    /// tables, unless there is no other.
    std::size_t next() {
        if (!m_cold || m_next == m_photos.size()) {
            m_cold.emplace(m_dataset, render::RendererOptions{.verify = m_verify});
            m_next = m_photos.size() > 1 ? 1 : 0;
            if (m_next == 1) {
                renderFrom(*m_cold, m_photos.front(), 0);
            }
        }
        return m_photos[m_next++];
    }

    void prepare(std::size_t photo) {
        const render::DatasetPhoto& entry = m_dataset->info().photos[photo];
        for (const std::string& name : {entry.file, entry.restartIndex}) {
            if (name.empty()) {
                continue;
            }
            if (m_from == From::SystemCache) {
                readFile(m_dataset->folder() / name);
            } else {
                m_filesDropped = dropFromFileCache(m_dataset->folder() / name) && m_filesDropped;
            }
        }
    }

    void renderFrom(const render::Renderer& renderer, std::size_t photo, int turn) {
        const Rigid3& roomFromPhoto = m_dataset->info().photos[photo].roomFromPhoto;
        renderer.render(m_camera, roomFromPhoto * lookingTo(5.7 * turn, 0), {}, m_view);
    }

    void wholeAndRender(std::size_t photo, int turn) {
        const std::string& file = m_dataset->info().photos[photo].file;
        const Bytes bytes = m_verify == VerifyPhotos::BeforeUse ? m_dataset->readPhoto(photo)
                                                                : readFile(m_dataset->folder() / file);
        m_whole = jpeg::decode(bytes, file);
        renderFrom(m_warm, m_photos.front(), turn % 2); // of one that is in memory
    }

    std::shared_ptr<const render::Dataset> m_dataset;
    VerifyPhotos m_verify;
    From m_from;
    CameraModel m_camera = standardCamera(90);
    std::vector<std::size_t> m_photos;
    std::size_t m_next = 0;
    render::Renderer m_warm;
    std::optional<render::Renderer> m_cold;
    render::View m_view;
    RgbImage m_whole;
    std::vector<double> m_ownMs;
    std::vector<double> m_peerMs;
    PartsOfViews m_parts;
    bool m_filesDropped = true;
};

} // namespace

bool dropFromFileCache(const std::filesystem::path& file) {
    const Descriptor descriptor(file);
    ::fdatasync(descriptor.number()); // what is not yet on the disk cannot be forgotten
    ::posix_fadvise(descriptor.number(), 0, 0, POSIX_FADV_DONTNEED);
    return !isCached(descriptor);
}

ColdCells measureColdCells(const std::shared_ptr<const render::Dataset>& dataset, int views,
                           ProgressSink& progress, const std::stop_token& stop) {
    ColdCells result;
    // What is not verified in the background stays unverified: no stream runs here.
    using From = ColdCell::From;
    ColdCell cached(dataset, VerifyPhotos::BeforeUse, From::SystemCache);
    ColdCell unverified(dataset, VerifyPhotos::InBackground, From::SystemCache);
    ColdCell disk(dataset, VerifyPhotos::BeforeUse, From::Disk);
    for (int i = 0; i < views; ++i) {
        for (ColdCell* cell : {&cached, &unverified, &disk}) {
            throwIfStopped(stop);
            cell->measureOne(i);
        }
        progress.progress(static_cast<double>(i + 1) / views, "Timing first views of photos");
    }
    result.rows = {cached.row("cold_cell"), unverified.row("cold_cell.unverified"),
                   disk.row("cold_cell.disk")};
    result.filesDropped = disk.filesDropped();
    return result;
}

} // namespace spherewalk::bench
