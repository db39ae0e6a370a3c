// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/base/json.h"
#include "spherewalk/render/lattice_error.h"
#include "spherewalk/render/sampling.h"
#include "spherewalk/render/view_stream.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::measure {

/// Milliseconds of many runs.
struct Measured {
    double medianMs = 0;
    double madMs = 0; ///< median of the absolute deviations from the median
};

struct Machine {
    std::string processor;
    int threads = 0; ///< that run at a time
    std::string simd;
    std::string buildType;
    std::string compiler;
    std::string version;     ///< of Spherewalk
    std::string peerVersion; ///< of OpenCV; "" without peers
    /// How much sooner two threads finish two pieces of arithmetic than one does: 2 if nothing else runs.
    /// What two threads gain elsewhere means something only beside this.
    double twoThreadGain = 0;
};

struct Measurand {
    std::string dataset; ///< its name
    std::size_t photos = 0;
    int photoWidth = 0; ///< of the photo that was measured
    int photoHeight = 0;
    std::uint64_t photoBytes = 0;
    bool decodesParts = false; ///< the photo has restart markers
    int viewWidth = 0;
    int viewHeight = 0;
};

/// Where a view looks.
struct ViewSetting {
    double fieldDeg = 90;
    double pitchDeg = 0; ///< upwards
};

/// Medians of what ViewReport says of the same views.
struct ViewParts {
    double drawMs = 0;
    double decodeMs = 0;
};

/// The same work done by something else in the same run.
struct Peer {
    std::string name;
    double medianMs = 0;
};

struct BenchRow {
    std::string name; ///< such as "view.footprint"
    int threads = 1;
    Measured own;
    std::optional<Peer> peer;
    std::optional<ViewSetting> view; ///< of rows "view...." and "cold_cell..."
    std::optional<ViewParts> parts;  ///< of the same
    std::uint64_t bytes = 0;         ///< of the pixels that come out, of rows "decode...."

    /// The peer's time over ours: how many times as fast we are. Range: with a peer.
    double ratio() const { return peer->medianMs / own.medianMs; }
};

/// Likeness of a rung to the mean over each pixel's area.
struct RungFidelity {
    render::Sampling rung = render::Sampling::Footprint;
    double fieldDeg = 0;
    double meanDb = 0;
    double worstDb = 0;
};

struct LatticeRow {
    render::LatticeSearch search = render::LatticeSearch::AnyDirection;
    render::LatticeError error;
};

/// One walk in real time at 30 views a second.
struct WalkRow {
    double speedMS = 0;
    render::LatePolicy policy = render::LatePolicy::Wait;
    bool prefetch = true;
    int views = 0;
    int lateAtStart = 0;    ///< of the ten views before, which begin with nothing in memory
    double lateShare = 0;   ///< of views something of which was not in memory when they were asked for
    double p99Ms = 0;       ///< from asking for a view to having it
    double missedShare = 0; ///< of views that took longer than 1/30 s
};

struct WalkedPast {
    std::size_t photos = 0;
    double lengthM = 0;
    bool copies = false; ///< of one photo, made for the walk
};

struct Residence {
    std::uint64_t peakBytes = 0; ///< of the whole program, after looking all round at each photo
    std::size_t photos = 0;      ///< that were looked at
};

struct BenchReport {
    bool quick = false;
    Machine machine;
    Measurand measurand;
    std::vector<BenchRow> rows;
    bool coldFilesDropped = false; ///< of row "cold_cell.disk": they were read from the disk indeed
    int directions = 0;            ///< that fidelity was measured in
    std::vector<RungFidelity> fidelity;
    std::vector<LatticeRow> lattice;
    WalkedPast walkedPast;
    std::vector<WalkRow> walk;
    Residence residence;

    /// The first row of this name, number of threads and peer ("" for any); null if there is none.
    const BenchRow* find(const std::string& name, int threads, const std::string& peer = {}) const;
};

/// machine, dataset, rows, fidelity, lattice, walk, resident_bytes. Members of what was not compared are
/// null.
Json toJson(const BenchReport& report);

/// Tables for people, and what they say in plain words.
std::string benchTable(const BenchReport& report);

/// A picture for people: error against time of each rung, and late views against speed. Shape: SVG.
std::string benchPlot(const BenchReport& report);

} // namespace spherewalk::measure
