// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "measurements.h"
#include "random.h"

#include "spherewalk/bench/bench_report.h"

#include <string>

namespace spherewalk::test {

/// The settings of views that a run times.
inline constexpr std::array<bench::ViewSetting, 4> kTimedSettings{{{90, 0}, {90, 80}, {57, 0}, {57, 80}}};

/// A report as a run with peers could fill it. The figures are random.
class MadeReport {
  public:
    explicit MadeReport(Random& random) : m_random(random) {}

    bench::BenchReport fill() {
        m_report.machine = {"Some processor", 2, "AVX2", "Release", "GCC", "1.2", "OpenCV 4", 1.9};
        m_report.measurand = {"kitchen", 404, 5376, 2688, 4'000'000, true, 640, 480};
        for (const bench::ViewSetting& setting : kTimedSettings) {
            addViews(setting);
        }
        for (const char* name : {"view.with_depth", "view.with_overlay"}) {
            add(name, 1, bench::kViewAlone).view = bench::ViewSetting{};
        }
        add("scene.room.footprint", 1, bench::kSphereView);
        add("decode.whole", 1, bench::kLibjpegWhole).bytes = 43'000'000;
        add("decode.thumbnail", 1).bytes = 96'000;
        for (const char* name : {"cold_cell", "cold_cell.unverified", "cold_cell.disk"}) {
            bench::BenchRow& row = add(name, 2, bench::kWholeAndRender);
            row.view = bench::ViewSetting{};
            row.parts = bench::ViewParts{1, 0.5 * row.own.medianMs};
        }
        for (const bench::LatticeSearch search : bench::kLatticeSearches) {
            m_report.lattice.push_back({search, {m_random.uniform(0, 0.02), "here", 0.5, {}, 1000, true}});
        }
        addFidelity();
        addWalks();
        m_report.residence = {612'000'000, 404};
        return m_report;
    }

  private:
    /// The reference holds until the next row is added.
    bench::BenchRow& add(const std::string& name, int threads, const char* peer = nullptr) {
        bench::BenchRow& row = m_report.rows.emplace_back();
        row.name = name;
        row.threads = threads;
        row.own = {std::pow(10, m_random.uniform(-0.5, 2)), 0.01};
        if (peer != nullptr) {
            row.peer = {peer, std::pow(10, m_random.uniform(-0.5, 2))};
        }
        return row;
    }

    void addViews(const bench::ViewSetting& setting) {
        for (const render::Sampling rung : bench::kRungs) {
            for (const char* peer : {bench::kMapsAndRemap, bench::kRemap, bench::kRemapSameMap}) {
                addView(rung, setting, 1, peer);
            }
            addView(rung, setting, 2, bench::kOneThread);
        }
    }

    void addView(render::Sampling rung, const bench::ViewSetting& setting, int threads, const char* peer) {
        bench::BenchRow& row = add(viewRowName(rung, setting), threads, peer);
        row.view = setting;
        row.parts = bench::ViewParts{0.9 * row.own.medianMs, 0};
    }

    void addFidelity() {
        m_report.directions = 40;
        for (const double field : {90.0, 57.0}) {
            for (const render::Sampling rung : bench::kRungs) {
                const double worst = m_random.uniform(20, 45);
                m_report.fidelity.push_back({rung, field, worst + m_random.uniform(1, 10), worst});
            }
        }
    }

    void addWalks() {
        m_report.walkedPast = {404, 80.6, true};
        for (const double speed : {1.0, 5.0, 20.0}) {
            for (const bool prefetch : {true, false}) {
                m_report.walk.push_back({speed, render::LatePolicy::Wait, prefetch, 90,
                                         m_random.integer(0, 10), m_random.uniform(0, 1),
                                         m_random.uniform(1, 200), m_random.uniform(0, 1)});
            }
        }
    }

    Random& m_random;
    bench::BenchReport m_report;
};

} // namespace spherewalk::test
