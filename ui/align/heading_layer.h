// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plan/plan_canvas.h"

#include "spherewalk/jobs/solution_findings.h"

#include <vector>

namespace spherewalk::ui {

/// Draws on the plan how each photo is turned: a line from where it was solved to be, along its heading, with
/// a fan of three standard deviations, magnified so that it can be seen.
class HeadingLayer : public PlanLayer {
  public:
    static constexpr double kMagnified = 50; ///< the fans, in angle

    void setPhotos(const std::vector<jobs::PhotoFinding>& photos) { m_photos = photos; }

    void paint(QPainter& painter, const QTransform& widgetFromRoom) override;

  private:
    std::vector<jobs::PhotoFinding> m_photos;
};

} // namespace spherewalk::ui
