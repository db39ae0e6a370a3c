// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json_fwd.h"
#include "spherewalk/bench/lattice_error.h"
#include "spherewalk/render/ladder.h"
#include "spherewalk/render/view_stream.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::bench {

/// The times of many runs.
struct Measured {
    double medianMs = 0;
    double madMs = 0; ///< Median of the absolute deviations from the median.
};

struct Machine {
    std::string processor;
    int threads = 0; ///< Number of threads that run at a time.
    std::string simd;
    std::string buildType;
    std::string compiler;
    std::string version;     ///< Version of Spherewalk.
    std::string peerVersion; ///< Version of OpenCV; "" without peers.
    /// How much sooner two threads finish two pieces of arithmetic than one thread: 2 if nothing else runs.
    /// Compare what two threads gain elsewhere with this number.
    double twoThreadGain = 0;
};

/// The dataset, its photo that was measured, and the size of views.
struct Measurand {
    std::string dataset; ///< Name of the dataset.
    std::size_t photos = 0;
    int photoWidth = 0;
    int photoHeight = 0;
    std::uint64_t photoBytes = 0;
    bool decodesParts = false; ///< The photo has restart markers.
    int viewWidth = 0;
    int viewHeight = 0;
};

/// Where a view looks.
struct ViewSetting {
    double fieldDeg = 90;
    double pitchDeg = 0; ///< Upwards.
};

/// Medians of the times that ViewReport gives for the same views.
struct ViewParts {
    double drawMs = 0;
    double decodeMs = 0;
};

/// Another way to do the same work, timed in the same run.
struct Peer {
    std::string name;
    double medianMs = 0;
};

struct BenchRow {
    std::string name; ///< Such as "view.footprint".
    int threads = 1;
    Measured own;
    std::optional<Peer> peer;
    std::optional<ViewSetting> view; ///< Rows "view...." and "cold_cell..." have it.
    std::optional<ViewParts> parts;  ///< The same rows have it.
    std::uint64_t bytes = 0;         ///< Rows "decode....": size of the decoded pixels.

    /// The peer's time over ours: how many times as fast we are. Range: a row with a peer.
    double ratio() const { return peer->medianMs / own.medianMs; }
};

/// Likeness of a sampling to the mean over each pixel's area: peak signal to noise ratio over directions.
struct RungFidelity {
    render::Sampling rung = render::Sampling::Footprint;
    double fieldDeg = 0;
    double meanDb = 0;
    double worstDb = 0;
};

/// The worst error of the lattice's coordinates that one search found.
struct LatticeRow {
    LatticeSearch search = LatticeSearch::AnyDirection;
    LatticeError error;
};

/// One walk in real time at 30 views a second.
struct WalkRow {
    double speedMS = 0;
    render::LatePolicy policy = render::LatePolicy::Wait;
    bool prefetch = true;
    int views = 0;
    int lateAtStart = 0;    ///< Late views among the ten before, which begin with nothing in memory.
    double lateShare = 0;   ///< Share of views for which something was not in memory at the request.
    double p99Ms = 0;       ///< Time from the request to the view; 99 of 100 views took less.
    double missedShare = 0; ///< Share of views that took longer than 1/30 s.
};

/// The photos that the walks went past.
struct WalkedPast {
    std::size_t photos = 0;
    double lengthM = 0;
    bool copies = false; ///< The photos are copies of one photo, made for the walk.
};

struct Residence {
    std::uint64_t peakBytes = 0; ///< Peak of the program after looking all round at each photo.
    std::size_t photos = 0;      ///< Number of photos that were looked at.
};

struct BenchReport {
    bool quick = false;
    Machine machine;
    Measurand measurand;
    std::vector<BenchRow> rows;
    bool coldFilesDropped = false; ///< Row "cold_cell.disk" read files from the disk indeed.
    int directions = 0;            ///< Fidelity was measured in so many directions.
    std::vector<RungFidelity> fidelity;
    std::vector<LatticeRow> lattice;
    WalkedPast walkedPast;
    std::vector<WalkRow> walk;
    Residence residence;

    /// The first row of this name, number of threads and peer ("" for any); null if there is none.
    const BenchRow* find(const std::string& name, int threads, const std::string& peer = {}) const;
};

/// The report for programs: machine, dataset, rows, fidelity, lattice, walk, resident_bytes. The members
/// peer, peer_median_ms and ratio are null for rows without a peer.
Json toJson(const BenchReport& report);

/// Tables for people, and conclusions in plain words at the end.
std::string benchTable(const BenchReport& report);

/// A picture for people: error against time of each rung, and late views against speed. Shape: SVG.
std::string benchPlot(const BenchReport& report);

} // namespace spherewalk::bench
