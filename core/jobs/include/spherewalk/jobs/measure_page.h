// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "spherewalk/jobs/grid_study.h"
#include "spherewalk/jobs/measure_report.h"

#include <filesystem>

namespace spherewalk::jobs {

/// What a report shows. Owner: what it points to must outlive it.
struct ReportContents {
    const render::DatasetInfo* dataset = nullptr;
    const MeasureReport* measured = nullptr; ///< null: not measured
    const GridStudy* grid = nullptr;         ///< null: not studied
};

/// Writes report.html (which needs no network), its pictures beside, the same as report.pdf, and report.json
/// into the folder, which is made if need be. Errors: Io, Full; Internal.
void writeReport(const ReportContents& contents, const std::filesystem::path& folder);

} // namespace spherewalk::jobs
