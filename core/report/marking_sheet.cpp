// SPDX-License-Identifier: GPL-3.0-or-later
#include "pdf_page.h"

#include "spherewalk/base/text.h"
#include "spherewalk/report/printed_sheets.h"
#include "spherewalk/survey/marking.h"
#include "spherewalk/survey/room_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

namespace spherewalk::report {

using Eigen::Vector2d;
using survey::MarkedPoint;
using survey::RailMark;

namespace {

constexpr double kTinyMm = 2.6;
constexpr double kSmallMm = 3;
constexpr double kNormalMm = 3.6;
constexpr double kLargeMm = 6;
constexpr double kLeastForLengthMm = 14; ///< a shorter wall has no room for its length

constexpr double kMapWidthMm = 180; ///< Room for the small map above a table.
constexpr double kMapHeightMm = 52;
constexpr double kTableMm = kMarginMm + 14 + kMapHeightMm + 8; ///< Base line of the table's head.
constexpr double kNumberMm = 4.6;                              ///< Columns of the table, from the margin.
constexpr double kStopsMm = 15;
constexpr double kFirstMm = 28;
constexpr double kLastMm = 98;
constexpr double kErrorMm = 171;

/// The pattern with %1, %2 ... replaced.
std::string filled(std::string pattern, const std::vector<std::string>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::string place = text("%", i + 1);
        if (const std::size_t at = pattern.find(place); at != std::string::npos) {
            pattern.replace(at, place.size(), values[i]);
        }
    }
    return pattern;
}

/// One sheet being drawn.
class MarkingSheet {
  public:
    MarkingSheet(const std::string& name, const survey::Room& room, const survey::PlanOptions& options,
                 const survey::Plan& plan, const SheetWords& words)
        : m_name(name),
          m_room(room),
          m_options(options),
          m_plan(plan),
          m_words(words),
          m_parts(room),
          m_rooms(m_parts.ofRails(plan)),
          m_layout(layoutOf(room.outline)),
          m_pages(m_layout.paper) {}

    Bytes draw() {
        drawTitle();
        drawRoom();
        for (std::size_t i = 0; i < m_plan.placements.size(); ++i) {
            drawRail(m_plan.placements[i], i);
        }
        drawNames();
        drawScale();
        drawTable(survey::railMarks(m_room, m_plan));
        return m_pages.finish();
    }

  private:
    Polygon onPaper(const Polygon& inRoom) const {
        Polygon result;
        for (const Vector2d& corner : inRoom) {
            result.push_back(m_layout.paperFromRoom(corner));
        }
        return result;
    }

    void drawTitle() {
        m_pages.setGrey(0);
        m_pages.words({kMarginMm, kMarginMm + kLargeMm}, filled(m_words.title, {m_name}), kLargeMm,
                      Align::Left, true);
        const double railM = (m_options.railStops - 1) * m_options.stepM;
        m_pages.words(
            {kMarginMm, kMarginMm + 13},
            filled(m_words.summary,
                   {std::to_string(m_plan.stations.size()), std::to_string(m_plan.placements.size()),
                    text(100 * m_options.stepM), std::to_string(m_options.railStops), fixed(railM, 2)}),
            kNormalMm);
    }

    void drawRoom() {
        m_pages.setGrey(0.6);
        m_pages.setLine(0.15);
        for (const Polygon& obstacle : m_room.obstacles) {
            m_pages.hatched(onPaper(obstacle));
        }
        m_pages.setGrey(0);
        m_pages.setLine(0.7);
        const Polygon walls = onPaper(m_room.outline);
        m_pages.outline(walls);
        drawCorners(walls);
        for (std::size_t i = 0; i < walls.size(); ++i) {
            const std::size_t next = (i + 1) % walls.size();
            if ((walls[next] - walls[i]).norm() > kLeastForLengthMm) {
                drawLength(walls, i, (m_room.outline[next] - m_room.outline[i]).norm());
            }
        }
    }

    /// The name of each corner inside of the room, with a line to its corner.
    void drawCorners(const Polygon& walls) {
        constexpr double kAwayMm = 7;
        constexpr double kRadiusMm = 2.2;
        const double metresAMm = m_layout.scale / 1000.0;
        const std::vector<Vector2d> labels =
            survey::cornerLabels(m_room, m_plan, kAwayMm * metresAMm, kRadiusMm * metresAMm);
        m_pages.setLine(0.12);
        for (std::size_t i = 0; i < walls.size(); ++i) {
            const Vector2d at = m_layout.paperFromRoom(labels[i]);
            if (const double length = (at - walls[i]).norm(); length > kRadiusMm) {
                m_pages.line(walls[i], at - kRadiusMm / length * (at - walls[i]));
            }
            m_letters.push_back(at);
            m_pages.words(at + Vector2d(0, 1.3), survey::cornerName(static_cast<int>(i)), kNormalMm,
                          Align::Centre, true);
        }
    }

    /// Writes the length of a wall beside it: outside, or inside where the floor goes on behind the wall.
    void drawLength(const Polygon& walls, std::size_t wall, double metres) {
        const Vector2d& begin = walls[wall];
        const Vector2d& end = walls[(wall + 1) % walls.size()];
        const Vector2d along = (end - begin).normalized();
        const double sign = signedArea(m_room.outline) > 0 ? 1 : -1;
        const Vector2d outside(-sign * along.y(), sign * along.x()); // y points down on paper
        const std::string words = text(fixed(metres, 2), " m");
        const double widthMm = m_pages.widthOf(words, kSmallMm, false);
        // Above or below a level wall, to the side of an upright one.
        const double reachMm = 0.5 * (std::abs(outside.x()) * widthMm + std::abs(outside.y()) * kSmallMm);
        const auto at = [&](double side, double share) -> Vector2d {
            return begin + share * (end - begin) + side * (1.5 + reachMm) * outside;
        };
        bool isFree = true;
        for (const double x : {-0.5, 0.0, 0.5}) {
            isFree = isFree && !contains(walls, at(1, 0.5) + Vector2d(x * widthMm, 0));
        }
        constexpr std::array<double, 7> kShares = {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8};
        const double share =
            isFree ? kShares[0] : *std::min_element(kShares.begin(), kShares.end(), [&](double a, double b) {
                return crowding(at(-1, a), widthMm) < crowding(at(-1, b), widthMm);
            });
        m_pages.words(at(isFree ? 1 : -1, share) + Vector2d(0, 0.35 * kSmallMm), words, kSmallMm,
                      Align::Centre);
    }

    /// How much words of this width around a place would lie over rails and, which is worse, their numbers.
    int crowding(const Vector2d& middle, double widthMm) const {
        constexpr double kApartMm = 2;
        constexpr double kFromNumberMm = 3;
        const Vector2d half(0.5 * widthMm, 0);
        int result = 0;
        for (const survey::RailPlacement& rail : m_plan.placements) {
            const Polygon line = onPaper({rail.stop(0), rail.stop(rail.stops - 1)});
            const Vector2d number = (line[0] - middle).cwiseAbs();
            result += distanceToEdge(line, middle - half, middle + half) < kApartMm ? 1 : 0;
            result += number.x() < kFromNumberMm + half.x() && number.y() < 2 * kFromNumberMm ? 2 : 0;
        }
        return result;
    }

    void drawRail(const survey::RailPlacement& rail, std::size_t index) {
        const Vector2d first = m_layout.paperFromRoom(rail.stop(0));
        const Vector2d last = m_layout.paperFromRoom(rail.stop(rail.stops - 1));
        m_pages.setGrey(0);
        m_pages.setLine(0.25);
        m_pages.ring(first, 1.2);
        for (int k = 1; k < rail.stops; ++k) {
            m_pages.disc(m_layout.paperFromRoom(rail.stop(k)), 0.45);
        }
        if (rail.stops > 1) {
            drawArrow(first, last);
        }
        drawNumber(first, std::to_string(index + 1));
    }

    /// Writes the number of a rail beside its first stop, where no letter of a corner is.
    void drawNumber(const Vector2d& stop, const std::string& number) {
        constexpr double kFreeMm = 4.5;
        const double widthMm = m_pages.widthOf(number, kSmallMm, true);
        Vector2d best = stop;
        double most = -1;
        for (const Vector2d& side : {Vector2d(1, -1), Vector2d(-1, -1), Vector2d(1, 1), Vector2d(-1, 1)}) {
            const Vector2d middle = stop + Vector2d(side.x() * (1.6 + 0.5 * widthMm), 2.4 * side.y());
            double nearest = kFreeMm;
            for (const Vector2d& letter : m_letters) {
                nearest = std::min(nearest, (letter - middle).norm());
            }
            if (nearest > most) {
                most = nearest;
                best = middle;
            }
        }
        m_pages.words(best + Vector2d(0, 0.35 * kSmallMm), number, kSmallMm, Align::Centre, true);
    }

    void drawArrow(const Vector2d& first, const Vector2d& last) {
        const Vector2d along = (last - first).normalized();
        const Vector2d across(-along.y(), along.x());
        m_pages.line(first + 1.2 * along, last);
        m_pages.line(last, last - 2.2 * along + 1.1 * across);
        m_pages.line(last, last - 2.2 * along - 1.1 * across);
    }

    /// Writes the names of rooms on the plan, in grey, as rails and letters may lie over them.
    void drawNames() {
        m_pages.setGrey(0.45);
        for (const survey::RoomName& room : m_room.names) {
            m_pages.words(m_layout.paperFromRoom(room.at), room.name, kNormalMm, Align::Centre, true);
        }
        m_pages.setGrey(0);
    }

    void drawScale() {
        const double y = m_layout.paper.heightMm - kMarginMm;
        constexpr double kBarMm = 100;
        m_pages.setGrey(0);
        m_pages.setLine(0.4);
        m_pages.line({kMarginMm, y - 6}, {kMarginMm + kBarMm, y - 6});
        for (int cm = 0; cm <= 10; ++cm) {
            m_pages.line({kMarginMm + 10.0 * cm, y - 6},
                         {kMarginMm + 10.0 * cm, y - (cm % 5 == 0 ? 9 : 7.5)});
        }
        m_pages.words({kMarginMm, y - 1}, filled(m_words.scale, {std::to_string(m_layout.scale)}), kSmallMm);
    }

    /// The tables, with a page of its own for each room of a flat.
    void drawTable(const std::vector<RailMark>& marks) {
        constexpr double kRowMm = 10;
        const Paper paper{210, 297};
        int page = 1;
        for (std::size_t begin = 0; begin < marks.size();) {
            const std::size_t end = endOfPage(marks, begin);
            m_pages.nextPage(paper);
            m_pages.words({paper.widthMm - kMarginMm, paper.heightMm - kMarginMm},
                          filled(m_words.page, {std::to_string(++page)}), kSmallMm, Align::Right);
            drawMap(begin, end);
            drawTableHead(roomOf(marks[begin]));
            for (std::size_t i = begin; i < end; ++i) {
                drawRow(marks[i], kTableMm + static_cast<double>(i - begin + 1) * kRowMm);
            }
            begin = end;
        }
    }

    /// The rail after the last one on the page that begins with this rail.
    std::size_t endOfPage(const std::vector<RailMark>& marks, std::size_t begin) const {
        constexpr std::size_t kRows = 18;
        std::size_t end = begin + 1;
        while (end < marks.size() && end < begin + kRows && roomOf(marks[end]) == roomOf(marks[begin])) {
            ++end;
        }
        return end;
    }

    /// The name of the room that a rail lies in; "" where rooms have no names.
    std::string roomOf(const RailMark& mark) const {
        return m_rooms.empty() ? std::string()
                               : m_parts.names()[m_rooms[static_cast<std::size_t>(mark.placement)]];
    }

    /// Draws the whole room small, with the rails of this page in black and by their numbers.
    void drawMap(std::size_t begin, std::size_t end) {
        const Bounds2 room = bounds(m_room.outline);
        const Vector2d size = room.greatest - room.least;
        const double mmAMetre = std::min(kMapWidthMm / size.x(), kMapHeightMm / size.y());
        const Vector2d middle(105, kMarginMm + 14 + 0.5 * kMapHeightMm);
        const auto onMap = [&](const Vector2d& pInRoom) -> Vector2d {
            const Vector2d mm = mmAMetre * (pInRoom - 0.5 * (room.least + room.greatest));
            return middle + Vector2d(mm.x(), -mm.y());
        };
        Polygon walls;
        for (const Vector2d& corner : m_room.outline) {
            walls.push_back(onMap(corner));
        }
        m_pages.setGrey(0);
        m_pages.setLine(0.3);
        m_pages.outline(walls);
        for (std::size_t i = 0; i < m_plan.placements.size(); ++i) {
            const survey::RailPlacement& rail = m_plan.placements[i];
            const bool isOfPage = i >= begin && i < end;
            m_pages.setGrey(isOfPage ? 0 : 0.7);
            m_pages.setLine(isOfPage ? 0.5 : 0.2);
            m_pages.disc(onMap(rail.stop(0)), isOfPage ? 0.6 : 0.3);
            m_pages.line(onMap(rail.stop(0)), onMap(rail.stop(rail.stops - 1)));
            if (isOfPage) {
                m_pages.words(onMap(rail.stop(0)) + Vector2d(0.8, -0.5), std::to_string(i + 1), kTinyMm);
            }
        }
        m_pages.setGrey(0);
    }

    void drawTableHead(const std::string& room) {
        m_pages.setGrey(0);
        m_pages.words({kMarginMm, kMarginMm + 4},
                      room.empty() ? m_words.tableTitle : text(room, ". ", m_words.tableTitle), kNormalMm,
                      Align::Left, true);
        m_pages.words({kMarginMm, kMarginMm + 9}, m_words.errorMeans, kSmallMm);
        const std::array<std::pair<double, std::string_view>, 5> columns = {{{kNumberMm, m_words.rail},
                                                                             {kStopsMm, m_words.stops},
                                                                             {kFirstMm, m_words.firstStop},
                                                                             {kLastMm, m_words.lastStop},
                                                                             {kErrorMm, m_words.error}}};
        for (const auto& [x, title] : columns) {
            m_pages.words({kMarginMm + x, kTableMm}, std::string(title), kSmallMm, Align::Left, true);
        }
        m_pages.setLine(0.3);
        m_pages.line({kMarginMm, kTableMm + 2}, {210 - kMarginMm, kTableMm + 2});
    }

    void drawRow(const RailMark& mark, double bottom) {
        constexpr double kBelowMm = 4.2; ///< From the first line of a row to its second.
        const double y = bottom - kBelowMm;
        const auto& rail = m_plan.placements[static_cast<std::size_t>(mark.placement)];
        const bool hasLast = rail.stops > 1;
        m_pages.setLine(0.25);
        m_pages.outline({{kMarginMm, y}, {kMarginMm + 3, y}, {kMarginMm + 3, y - 3}, {kMarginMm, y - 3}});
        m_pages.words({kMarginMm + kNumberMm, y}, std::to_string(mark.placement + 1), kNormalMm, Align::Left,
                      true);
        m_pages.words({kMarginMm + kStopsMm, y}, std::to_string(rail.stops), kNormalMm);
        if (hasLast) {
            m_pages.words({kMarginMm + kStopsMm, bottom}, text(fixed((rail.stops - 1) * rail.stepM, 3), " m"),
                          kTinyMm);
        }
        drawPoint(mark.first, kFirstMm, y, bottom);
        if (hasLast) {
            drawPoint(mark.last, kLastMm, y, bottom);
        }
        if (mark.first.errorM && mark.last.errorM) {
            const double worst = std::max(*mark.first.errorM, *mark.last.errorM);
            m_pages.words({kMarginMm + kErrorMm, y}, text(fixed(1000 * worst, 0), " mm"), kNormalMm);
        }
        m_pages.setGrey(0.8);
        m_pages.setLine(0.1);
        m_pages.line({kMarginMm, bottom + 1.6}, {210 - kMarginMm, bottom + 1.6});
        m_pages.setGrey(0);
    }

    /// Writes the tapes of a point, and below them the check and the coordinates.
    void drawPoint(const MarkedPoint& point, double column, double y, double below) {
        m_pages.words({kMarginMm + column, y}, tapesText(point), kNormalMm);
        const std::string place =
            filled(m_words.place, {fixed(point.point.x(), 3), fixed(point.point.y(), 3)});
        m_pages.words({kMarginMm + column, below},
                      point.check ? text(filled(m_words.check, {tapeText(*point.check)}), "   ", place)
                                  : place,
                      kTinyMm);
    }

    std::string tapesText(const MarkedPoint& point) const {
        if (point.tapes.empty()) {
            return m_words.noTapes;
        }
        return text(tapeText(point.tapes[0]), "     ", tapeText(point.tapes[1]));
    }

    std::string tapeText(const survey::TapeDistance& tape) const {
        return text(originName(tape.from), "  ", fixed(tape.metres, 3));
    }

    std::string originName(const survey::TapeOrigin& origin) const {
        using Kind = survey::TapeOrigin::Kind;
        switch (origin.kind) {
        case Kind::Corner:
            return survey::cornerName(origin.index);
        case Kind::FirstStop:
            return filled(m_words.ring, {std::to_string(origin.index + 1)});
        case Kind::LastStop:
            return filled(m_words.arrow, {std::to_string(origin.index + 1)});
        case Kind::Wall:
            return survey::wallName(m_room, origin.index);
        }
        return {};
    }

    const std::string& m_name;
    const survey::Room& m_room;
    const survey::PlanOptions& m_options;
    const survey::Plan& m_plan;
    const SheetWords& m_words;
    survey::RoomParts m_parts;
    std::vector<std::size_t> m_rooms; ///< The room of each rail; empty where rooms have no names.
    PageLayout m_layout;
    PdfPages m_pages;
    std::vector<Vector2d> m_letters; ///< Places of the corners' letters on the paper.
};

} // namespace

Bytes markingSheet(const std::string& name, const survey::Room& room, const survey::PlanOptions& options,
                   const survey::Plan& plan, const SheetWords& words) {
    room.validate();
    return MarkingSheet(name, room, options, plan, words).draw();
}

} // namespace spherewalk::report
