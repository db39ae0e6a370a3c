// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/geometry/polygon.h"
#include "spherewalk/measure/svg.h"
#include "spherewalk/render/dataset_format.h"

#include <functional>
#include <optional>
#include <string>

namespace spherewalk::jobs {

/// A dataset's room from above, y upwards.
class PlanDrawing {
  public:
    PlanDrawing(const render::DatasetInfo& info, std::string_view title, std::string_view below);

    measure::Svg& svg() { return m_svg; }

    measure::SvgPoint at(const Eigen::Vector2d& pInRoom) const;

    double pixels(double metres) const { return metres * m_pixelsAMetre; }

    /// How far a photo reaches: half the diagonal of a cell of the grid.
    double reachM() const { return m_reachM; }

    /// The floor within the reach of photos, in the colour of the nearest one. colour: of a photo by its
    /// index.
    void floor(const std::function<std::string(std::size_t)>& colour);
    void walls();
    /// Beside the plan, from the top.
    void legend(const std::string& colour, const std::string& words);

    std::string str() const { return m_svg.str(); }

  private:
    bool isFloor(const Eigen::Vector2d& pInRoom) const;
    std::optional<std::size_t> nearest(const Eigen::Vector2d& pInRoom) const;

    const render::DatasetInfo& m_info;
    Bounds2 m_bounds;
    double m_pixelsAMetre;
    double m_reachM;
    measure::Svg m_svg;
    double m_legendY;
};

} // namespace spherewalk::jobs
