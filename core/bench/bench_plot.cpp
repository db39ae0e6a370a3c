// SPDX-License-Identifier: GPL-3.0-or-later
#include "measurements.h"

#include "spherewalk/base/text.h"
#include "spherewalk/report/chart.h"

#include <algorithm>

namespace spherewalk::bench {

using report::Chart;
using report::evenTicks;
using report::Scale;
using report::Svg;
using report::SvgAnchor;
using report::SvgBox;
using report::SvgPoint;

namespace {

constexpr int kWidth = 1040;
constexpr int kHeight = 450;
constexpr SvgBox kErrors{75, 92, 400, 285};
constexpr SvgBox kWalks{605, 92, 400, 285};

struct RungPoint {
    std::string rung;
    double ms;
    RungFidelity fidelity;
};

/// The rungs at the first field of view at which both time and error were measured, level.
std::vector<RungPoint> rungPoints(const BenchReport& report) {
    std::vector<RungPoint> points;
    for (const RungFidelity& row : report.fidelity) {
        const BenchRow* view = report.find(viewRowName(row.rung, {row.fieldDeg, 0}), 1);
        if (view != nullptr && (points.empty() || points.front().fidelity.fieldDeg == row.fieldDeg)) {
            points.push_back({std::string(name(row.rung)), view->own.medianMs, row});
        }
    }
    return points;
}

struct PeerLine {
    std::string name;
    double ms;
};

std::vector<PeerLine> peerLines(const BenchReport& report, double fieldDeg) {
    std::vector<PeerLine> lines;
    for (const char* peer : {kRemap, kMapsAndRemap}) {
        const std::string row = viewRowName(render::Sampling::Bilinear, {fieldDeg, 0});
        if (const BenchRow* found = report.find(row, 1, peer)) {
            lines.push_back({peer, found->peer->medianMs});
        }
    }
    return lines;
}

/// Puts names where they cover nothing.
class Labels {
  public:
    explicit Labels(Svg& svg, const SvgBox& frame) : m_svg(svg), m_frame(frame) {}

    void keepFree(const SvgBox& box) { m_taken.push_back(box); }

    /// Beside a mark that reaches down to another height.
    void putAt(const SvgPoint& mark, double lowest, const std::string& words) {
        const double width = widthOf(words);
        put({{mark.x + 10, mark.y + 4},
             {mark.x - 10 - width, mark.y + 4},
             {mark.x - width / 2, mark.y - 11},
             {mark.x - width / 2, lowest + 18},
             {mark.x + 10, lowest + 4},
             {mark.x - 10 - width, lowest + 4},
             {mark.x - 4, lowest + 18},
             {mark.x - 4, mark.y - 11}},
            words);
    }

    /// Beside a line from top to bottom.
    void putAlong(double x, const std::string& words) {
        std::vector<SvgPoint> places;
        for (double y = m_frame.y + 15; y < m_frame.y + m_frame.height; y += 19) {
            places.push_back({x + 6, y});
            places.push_back({x - 6 - widthOf(words), y});
        }
        put(places, words);
    }

  private:
    static double widthOf(const std::string& words) { return Svg::extent({}, words, Svg::Text::Label).width; }

    /// At the first place that is free, or the first.
    void put(const std::vector<SvgPoint>& places, const std::string& words) {
        const auto free = std::find_if(places.begin(), places.end(), [&](const SvgPoint& place) {
            const SvgBox box = Svg::extent(place, words, Svg::Text::Label);
            return isInside(box) && std::none_of(m_taken.begin(), m_taken.end(),
                                                 [&](const SvgBox& taken) { return taken.overlaps(box); });
        });
        const SvgPoint& place = free == places.end() ? places.front() : *free;
        m_svg.text(place, words, Svg::Text::Label);
        keepFree(Svg::extent(place, words, Svg::Text::Label));
    }

    bool isInside(const SvgBox& box) const {
        return box.x >= m_frame.x && box.x + box.width <= m_frame.x + m_frame.width && box.y >= m_frame.y &&
               box.y + box.height <= m_frame.y + m_frame.height;
    }

    Svg& m_svg;
    SvgBox m_frame;
    std::vector<SvgBox> m_taken;
};

/// Axes about all points and lines.
void scaleErrors(Chart& chart, const std::vector<RungPoint>& points, const std::vector<PeerLine>& peers) {
    std::vector<double> ms;
    std::vector<double> db;
    for (const RungPoint& point : points) {
        ms.push_back(point.ms);
        db.push_back(point.fidelity.worstDb);
        db.push_back(point.fidelity.meanDb);
    }
    for (const PeerLine& peer : peers) {
        ms.push_back(peer.ms);
    }
    const auto [leastMs, mostMs] = std::minmax_element(ms.begin(), ms.end());
    const auto [leastDb, mostDb] = std::minmax_element(db.begin(), db.end());
    chart.xAxis(report::logarithmicTicks(0.8 * *leastMs, 1.2 * *mostMs), Scale::Logarithmic,
                "milliseconds a view");
    chart.yAxis(evenTicks(*leastDb - 0.5, *mostDb + 3, 8), Scale::Even, "likeness to the exact view, dB");
    chart.axisLines();
}

void drawErrors(Svg& svg, const BenchReport& report) {
    Chart chart(svg, kErrors);
    const std::vector<RungPoint> points = rungPoints(report);
    if (points.empty()) {
        chart.title("Error against time: not measured at one field of view");
        return;
    }
    const double field = points.front().fidelity.fieldDeg;
    const std::vector<PeerLine> peers = peerLines(report, field);
    chart.title(text("Samplings at ", field, " degrees, one thread: upper left is better"));
    scaleErrors(chart, points, peers);
    Labels labels(svg, chart.frame());
    for (const PeerLine& peer : peers) {
        const double x = chart.x(peer.ms);
        svg.line({x, kErrors.y}, {x, chart.bottom()}, Svg::Line::Dashed);
        labels.keepFree({x - 2, kErrors.y, 4, kErrors.height});
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::string_view colour = report::seriesColour(i);
        const SvgPoint mean{chart.x(points[i].ms), chart.y(points[i].fidelity.meanDb)};
        const double lowest = chart.y(points[i].fidelity.worstDb);
        svg.line(mean, {mean.x, lowest}, Svg::Line::Mark, colour);
        svg.line({mean.x - 5, lowest}, {mean.x + 5, lowest}, Svg::Line::Mark, colour);
        svg.circle(mean, 6, colour);
        labels.keepFree({mean.x - 6, mean.y - 6, 12, lowest - mean.y + 8});
    }
    for (const RungPoint& point : points) {
        labels.putAt({chart.x(point.ms), chart.y(point.fidelity.meanDb)}, chart.y(point.fidelity.worstDb),
                     point.rung);
    }
    for (const PeerLine& peer : peers) {
        labels.putAlong(chart.x(peer.ms), peer.name);
    }
    svg.text({kErrors.x, kHeight - 14}, "Dot: mean of all directions; end of its bar: the worst one",
             Svg::Text::Small);
}

std::string seriesName(const WalkRow& row) {
    return text(name(row.policy), row.prefetch ? "" : ", no prefetch");
}

struct Walks {
    std::vector<std::string> series;
    std::vector<double> speeds;
};

Walks walksOf(const BenchReport& report) {
    Walks walks;
    const auto addOnce = [](auto& list, const auto& value) {
        if (std::find(list.begin(), list.end(), value) == list.end()) {
            list.push_back(value);
        }
    };
    for (const WalkRow& row : report.walk) {
        addOnce(walks.series, seriesName(row));
        addOnce(walks.speeds, row.speedMS);
    }
    return walks;
}

void drawLegend(Svg& svg, const Walks& walks) {
    double x = kWalks.x;
    for (std::size_t i = 0; i < walks.series.size(); ++i) {
        svg.rectangle({x, kHeight - 24, 12, 12}, report::seriesColour(i));
        svg.text({x + 18, kHeight - 14}, walks.series[i], Svg::Text::Small);
        x += 18 + Svg::extent({}, walks.series[i], Svg::Text::Small).width + 16;
    }
}

void drawWalks(Svg& svg, const BenchReport& report) {
    Chart chart(svg, kWalks);
    const Walks walks = walksOf(report);
    if (walks.series.empty()) {
        chart.title("Walks: not measured");
        return;
    }
    double most = 0;
    for (const WalkRow& row : report.walk) {
        most = std::max(most, 100 * row.lateShare);
    }
    chart.title("Late views of a walk, 30 views a second: lower is better");
    chart.yAxis(evenTicks(0, std::max(most, 5.0), 6), Scale::Even, "late views, %");
    const double group = kWalks.width / static_cast<double>(walks.speeds.size());
    const double bar = std::min(18.0, 0.8 * group / static_cast<double>(walks.series.size()));
    for (std::size_t i = 0; i < walks.speeds.size(); ++i) {
        const double middle = kWalks.x + (static_cast<double>(i) + 0.5) * group;
        chart.tickText({middle, chart.bottom() + 18}, text(walks.speeds[i]), SvgAnchor::Middle);
        const double left = middle - 0.5 * bar * static_cast<double>(walks.series.size());
        for (const WalkRow& row : report.walk) {
            if (row.speedMS == walks.speeds[i]) {
                const auto series = static_cast<std::size_t>(
                    std::find(walks.series.begin(), walks.series.end(), seriesName(row)) -
                    walks.series.begin());
                // A sliver where nothing was late: it was measured.
                const double top = std::min(chart.y(100 * row.lateShare), chart.bottom() - 2);
                svg.rectangle(
                    {left + static_cast<double>(series) * bar + 1, top, bar - 2, chart.bottom() - top},
                    report::seriesColour(series));
            }
        }
    }
    chart.xCaption("metres a second");
    chart.axisLines();
    drawLegend(svg, walks);
}

} // namespace

std::string benchPlot(const BenchReport& report) {
    Svg svg(kWidth, kHeight, "Time and error of views, and late views of walks");
    svg.text(
        {24, 30},
        text("Spherewalk ", report.machine.version, ": dataset ", printable(report.measurand.dataset, 60)),
        Svg::Text::Title);
    svg.text({24, 50},
             text(report.machine.processor, ", ", report.machine.simd, "; views of ",
                  report.measurand.viewWidth, " x ", report.measurand.viewHeight, " from a photo of ",
                  report.measurand.photoWidth, " x ", report.measurand.photoHeight, " pixels"),
             Svg::Text::Small);
    drawErrors(svg, report);
    drawWalks(svg, report);
    return svg.str();
}

} // namespace spherewalk::bench
