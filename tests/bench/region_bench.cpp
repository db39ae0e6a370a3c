// SPDX-License-Identifier: Apache-2.0
// Measures what the renderer's loading parts cost: decoding a view's region against the whole photo, a cold
// cell, and a walk at rising speed. Usage: spherewalk_region_bench [PHOTO.jpg]
#include "loader.h"
#include "loader_photos.h"
#include "prefetch.h"
#include "temporary_folder.h"
#include "tile_footprint.h"

#include "spherewalk/base/clock.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/parallel.h"
#include "spherewalk/base/sha256.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/rotation.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/jpeg/restart.h"
#include "spherewalk/render/projection.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fcntl.h>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <thread>
#include <unistd.h>

namespace {

using namespace spherewalk;
using namespace spherewalk::render;
using Eigen::Vector2d;
using Eigen::Vector3d;
using SteadyClock = std::chrono::steady_clock;

constexpr int kPhotos = 404;
constexpr double kGridM = 0.2;
constexpr double kFrameS = 1.0 / 30;
// What a path bends within the horizon: tiles this far beyond the predicted view are decoded too.
constexpr double kPredictionPx = 24;

double since(SteadyClock::time_point begin) {
    return std::chrono::duration<double, std::milli>(SteadyClock::now() - begin).count();
}

double quantile(std::vector<double> values, double share) {
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

double medianOf(int rounds, const std::function<void()>& work) {
    std::vector<double> times;
    for (int i = 0; i < rounds; ++i) {
        const auto begin = SteadyClock::now();
        work();
        times.push_back(since(begin));
    }
    return quantile(times, 0.5);
}

/// How much sooner two threads finish two pieces of arithmetic than one does: 2 if the machine is ours alone.
/// A ratio between thread counts means something only beside this.
double sharedProcessors() {
    const auto spin = [](int, int) {
        volatile double value = 1;
        for (int i = 0; i < 3'000'000; ++i) {
            value = value * 1.0000001;
        }
    };
    constexpr int kRounds = 9;
    const double one = medianOf(kRounds, [&] { parallelFor(2, 1, 1, spin); });
    return one / medianOf(kRounds, [&] { parallelFor(2, 1, 2, spin); });
}

RgbImage proceduralPicture(int width) {
    RgbImage picture(width, width / 2);
    unsigned noise = 1;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < 3; ++c) {
                noise = noise * 1664525 + 1013904223;
                const double wave = std::sin(0.02 * (c + 1) * x) * std::cos(0.03 * y + c);
                picture.at(x, y)[c] = static_cast<std::uint8_t>(120 + 80 * wave + (noise >> 24) % 24);
            }
        }
    }
    return picture;
}

/// kB of a line of /proc/self/status; 0 where there is none.
long memoryKb(const std::string& key) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.rfind(key + ":", 0) == 0) {
            return std::stol(line.substr(key.size() + 1));
        }
    }
    return 0;
}

struct Camera {
    CameraModel model{CameraIntrinsics::pinhole(640, 480, std::numbers::pi / 2)};
    ViewFootprint footprint{model};
};

/// A serpentine of copies of one photo, 20 cm apart.
class Room {
  public:
    Room(const test::TemporaryFolder& folder, const Bytes& marked, const jpeg::RestartIndex& index) {
        DatasetInfo info;
        info.id = info.surveyId = "00000000-0000-4000-8000-000000000000";
        info.name = info.madeBy = "bench";
        info.createdUtc = "2026-01-01T00:00:00.000Z";
        info.sphereRadiusM = 2.5;
        for (const char* name : {"photos", "index", "thumbnails"}) {
            std::filesystem::create_directories(folder / name);
        }
        const std::string hash = sha256Hex(marked);
        const RgbImage small = jpeg::decode(marked, "photo", 8);
        const Bytes thumbnail = jpeg::encode(small, 80);
        for (int i = 0; i < kPhotos; ++i) {
            DatasetPhoto photo;
            photo.file = text("photos/", i, ".jpg");
            photo.restartIndex = text("index/", i, ".swri");
            photo.thumbnail = text("thumbnails/", i, ".jpg");
            photo.sha256 = hash;
            photo.sizeBytes = marked.size();
            photo.width = index.width;
            photo.height = index.height;
            photo.roomFromPhoto.translation = Vector3d(kGridM * i, 0, 1.2);
            photo.rotationSource = "imported";
            write(folder / photo.file, marked);
            write(folder / photo.restartIndex, jpeg::serialised(index));
            write(folder / photo.thumbnail, thumbnail);
            info.photos.push_back(photo);
        }
        writeFile(folder / kDatasetFile, bytesOf(toJson(info).dump()));
        dataset = std::make_shared<const Dataset>(Dataset::open(folder.path()));
    }

    TileSet tiles(const Rigid3& pose, std::size_t photo, double reachPx = 2) const {
        const DatasetPhoto& entry = dataset->info().photos[photo];
        const EquirectSize size{entry.width, entry.height};
        const Projection projection(camera.model, pose, entry.roomFromPhoto, size, SceneKind::Sphere,
                                    *dataset->info().sphereRadiusM);
        return camera.footprint.tiles(
            TileGrid(size), [&](const Vector2d& p) { return projection.photoPixel(p); }, reachPx);
    }

    TileNeed need(const Rigid3& pose, double reachPx = 2) const {
        const std::size_t photo = dataset->nearestPhoto(pose.translation);
        return {photo, tiles(pose, photo, reachPx)};
    }

    std::shared_ptr<const Dataset> dataset;
    Camera camera;

  private:
    static void write(const std::filesystem::path& file, const Bytes& bytes) {
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    }
};

Rigid3 looking(double x, double yaw) {
    return {yawRotation(Radians(yaw)) * bodyFromOptical(), Vector3d(x, 0.03, 1.2)};
}

void benchDecode(const Bytes& marked, const jpeg::RestartIndex& index, const Room& room) {
    const auto source = std::make_shared<MemorySource>(marked, "photo");
    const jpeg::RegionDecoder decoder(source, index);
    const RgbImage whole = jpeg::decode(marked, "photo");
    const TileSet tiles = room.tiles(looking(0, 0.4), 0);
    const TileGrid& grid = tiles.grid();
    int left = grid.columns();
    int right = 0;
    int top = grid.rows();
    int bottom = 0;
    tiles.forEach([&](int i) {
        left = std::min(left, i % grid.columns());
        right = std::max(right, i % grid.columns() + 1);
        top = std::min(top, i / grid.columns());
        bottom = std::max(bottom, i / grid.columns() + 1);
    });
    const jpeg::PixelRect region = grid.pixels(left, top, right, bottom);
    const RgbImage part = decoder.decode(region);
    for (int y = 0; y < region.height; ++y) {
        if (!std::equal(part.row(y).begin(), part.row(y).end(),
                        whole.row(region.y + y).begin() + 3 * region.x)) {
            std::printf("NOT IDENTICAL in row %d\n", y);
        }
    }
    // Each ratio compares like with like: both into a new picture, or both without keeping the pixels.
    constexpr int kRounds = 15;
    const double wholeMs = medianOf(kRounds, [&] { jpeg::decode(marked, "photo"); });
    const double partMs = medianOf(kRounds, [&] { decoder.decode(region); });
    std::printf("region %d x %d pixels, %d of %d tiles\n", region.width, region.height, tiles.count(),
                grid.count());
    std::printf("%-44s %8.2f ms\n", "whole into a picture, 1 thread", wholeMs);
    std::printf("%-44s %8.2f ms  %5.1fx\n", "region into a picture, 1 thread", partMs, wholeMs / partMs);
    const jpeg::PixelRect all{0, 0, index.width, index.height};
    const auto rgbxMs = [&](const jpeg::PixelRect& rectangle, int denominator, int threads) {
        jpeg::RegionOptions options;
        options.threads = threads;
        options.denominator = denominator;
        options.layout = jpeg::PixelLayout::Rgbx;
        return medianOf(kRounds,
                        [&] { decoder.decode(rectangle, options, [](int, const std::uint8_t*) {}); });
    };
    const double allMs = rgbxMs(all, 1, 1);
    const double allPlanesMs = medianOf(kRounds, [&] { decoder.decodePlanes(all); });
    const double pixels = static_cast<double>(index.width) * index.height;
    std::printf("%-44s %8.2f ms, %.1f MB if kept\n", "whole, RGBX, not kept, 1 thread", allMs, pixels * 4e-6);
    std::printf("%-44s %8.2f ms, %.1f MB\n", "whole, planes as stored, 1 thread", allPlanesMs,
                pixels * 1.5e-6);
    for (const int threads : {1, 2}) {
        for (const int denominator : {1, 2, 4, 8}) {
            const jpeg::PixelRect reduced{region.x / denominator, region.y / denominator,
                                          region.width / denominator, region.height / denominator};
            const double ms = rgbxMs(reduced, denominator, threads);
            std::printf("region, RGBX, not kept, 1/%d, %d thread(s)      %8.2f ms  %5.1fx\n", denominator,
                        threads, ms, allMs / ms);
        }
        const double ms = medianOf(kRounds, [&] { decoder.decodePlanes(region, threads); });
        std::printf("region, planes as stored, %d thread(s)         %8.2f ms  %5.1fx\n", threads, ms,
                    allPlanesMs / ms);
    }
    const double one = rgbxMs(region, 1, 1);
    const double two = rgbxMs(region, 1, 2);
    const double shared = sharedProcessors();
    std::printf("one thread to two: %.2fx faster; idle arithmetic gains %.2fx here and now\n", one / two,
                shared);
    std::printf("SHA-256 of the file: %.2f ms\n", medianOf(kRounds, [&] { sha256Hex(marked); }));
}

void benchCold(const Room& room, const test::TemporaryFolder& folder, double wholeMs) {
    for (const VerifyPhotos verify : {VerifyPhotos::InBackground, VerifyPhotos::BeforeUse}) {
        TileStore store(std::make_shared<LoaderPhotos>(room.dataset, verify), 512ULL << 20);
        std::vector<double> times;
        std::vector<double> footprints;
        for (std::size_t photo = 0; photo < 60; ++photo) {
            // The file's pages leave the system's cache, where it lets them.
            const int file = ::open((folder / room.dataset->info().photos[photo].file).c_str(), O_RDONLY);
            ::posix_fadvise(file, 0, 0, POSIX_FADV_DONTNEED);
            ::close(file);
            const auto begin = SteadyClock::now();
            const TileNeed need =
                room.need(looking(kGridM * static_cast<double>(photo), 0.1 * static_cast<double>(photo)));
            footprints.push_back(since(begin));
            store.acquire(need.photo, need.tiles, TileStore::Missing::Decode, 0);
            times.push_back(since(begin));
        }
        std::printf("cold cell, %-28s median %6.2f ms, worst %6.2f ms (tiles found in %.2f ms), %.1fx\n",
                    verify == VerifyPhotos::InBackground ? "verified in background" : "verified before use",
                    quantile(times, 0.5), quantile(times, 1), quantile(footprints, 0.5),
                    wholeMs / quantile(times, 0.5));
    }
}

/// Late: tiles were not there when asked for; missed: the view's tiles came after its 1/30 s.
void walk(const Room& room, double speed, LatePolicy policy, bool isAhead, int frames) {
    const auto photos = std::make_shared<LoaderPhotos>(room.dataset, VerifyPhotos::InBackground);
    TileStore store(photos, 512ULL << 20);
    ViewLoader loader(store, std::make_shared<Thumbnails>(room.dataset));
    Prefetcher prefetcher(store, [&](const std::stop_token& stop) { return photos->verifyNext(stop); });
    const double length = kGridM * (kPhotos - 1);
    std::vector<double> times;
    int missed = 0;
    std::string lateFrames;
    Rigid3 before;
    // The first two views show the motion, and are not counted.
    constexpr int kLeadIn = 2;
    LoaderCounters lead;
    const auto start = SteadyClock::now();
    for (int frame = 0; frame < frames; ++frame) {
        const auto due = start + std::chrono::duration_cast<SteadyClock::duration>(
                                     std::chrono::duration<double>(frame * kFrameS));
        systemClock().sleep(due - SteadyClock::now(), {});
        const auto begin = SteadyClock::now();
        const double along = std::fmod(speed * frame * kFrameS, 2 * length);
        const double x = along < length ? along : 2 * length - along;
        const Rigid3 pose = looking(x, 0.5 * std::sin(0.7 * frame * kFrameS));
        if (frame == kLeadIn) {
            lead = loader.counters();
        }
        TileNeed need = room.need(pose);
        {
            const TileStore::ViewInProgress view(store);
            const Served served = loader.serve(
                need, policy, [&](std::size_t photo) { return room.tiles(pose, photo); }, 0);
            if (served.isLate && lateFrames.size() < 12) {
                lateFrames += text(" ", frame);
            }
        }
        const double ms = since(begin);
        if (frame >= kLeadIn) {
            times.push_back(ms);
            missed += ms > 1000 * kFrameS ? 1 : 0;
        }
        std::vector<TileNeed> plan;
        if (isAhead && frame > 0) {
            plan = prefetchPlan(pose, motionBetween(before, pose, kFrameS), {0.2, kFrameS, 6000},
                                [&](const Rigid3& p) { return room.need(p, kPredictionPx); });
        }
        plan.insert(plan.begin(), std::move(need));
        prefetcher.setPlan(std::move(plan));
        before = pose;
    }
    const LoaderCounters& counters = loader.counters();
    const double views = static_cast<double>(counters.views - lead.views);
    const char* name = policy == LatePolicy::Wait     ? "wait"
                       : policy == LatePolicy::Coarse ? "coarse"
                                                      : "previous";
    std::printf(
        "%5.0f m/s  %-9s %-12s late %5.1f %%  missed %5.1f %%  p50 %6.2f  p99 %6.2f ms  resident %4llu MB  "
        "RSS %4ld MB  first late frames%s\n",
        speed, name, isAhead ? "prefetch" : "no prefetch",
        100 * static_cast<double>(counters.late - lead.late) / views, 100 * missed / views,
        quantile(times, 0.5), quantile(times, 0.99),
        static_cast<unsigned long long>(store.counters().residentBytes >> 20), memoryKb("VmRSS") >> 10,
        lateFrames.c_str());
}

void benchMemory(const Room& room) {
    const auto photos = std::make_shared<LoaderPhotos>(room.dataset, VerifyPhotos::InBackground);
    TileStore store(photos, 512ULL << 20);
    const auto begin = SteadyClock::now();
    long most = 0;
    // Each photo is looked at all round, as by a robot that turns on the spot at every one.
    for (std::size_t photo = 0; photo < kPhotos; ++photo) {
        for (int turn = 0; turn < 4; ++turn) {
            const Rigid3 pose = looking(kGridM * static_cast<double>(photo), turn * std::numbers::pi / 2);
            store.acquire(photo, room.tiles(pose, photo), TileStore::Missing::Decode, 0);
        }
        most = std::max(most, memoryKb("VmRSS"));
    }
    const TileCounters counters = store.counters();
    std::printf(
        "%d photos all round: %.1f s, resident %llu MB counted, RSS at most %ld MB, %llu tiles dropped\n",
        kPhotos, since(begin) / 1000, static_cast<unsigned long long>(counters.residentBytes >> 20),
        most >> 10, static_cast<unsigned long long>(counters.droppedTiles));
}

} // namespace

int main(int argc, char** argv) {
    try {
        const Bytes original = argc > 1 ? readFile(argv[1]) : jpeg::encode(proceduralPicture(5376), 92);
        const jpeg::Info info = jpeg::readInfo(original, "photo");
        const Bytes marked =
            jpeg::withRestartMarkers(original, jpeg::dividingInterval(info.width, info.mcuWidth, 8), "photo");
        const jpeg::RestartIndex index = jpeg::indexRestarts(marked, "photo");
        std::printf("photo %d x %d, %.2f MB, marked %.2f MB; %u processors\n", info.width, info.height,
                    double(original.size()) * 1e-6, double(marked.size()) * 1e-6,
                    std::thread::hardware_concurrency());
        const test::TemporaryFolder folder;
        const Room room(folder, marked, index);
        benchDecode(marked, index, room);
        benchCold(room, folder, medianOf(5, [&] { jpeg::decode(marked, "photo"); }));
        for (const double speed : {1.0, 2.0, 5.0, 10.0, 15.0, 20.0}) {
            walk(room, speed, LatePolicy::Wait, false, 90);
            for (const LatePolicy policy : {LatePolicy::Wait, LatePolicy::Coarse, LatePolicy::Previous}) {
                walk(room, speed, policy, true, 90);
            }
        }
        benchMemory(room);
        return 0;
    } catch (const Error& error) {
        std::fprintf(stderr, "%s\n", error.sentence().c_str());
        return 1;
    }
}
