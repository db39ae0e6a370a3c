// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/command.h"

#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/store/survey_store.h"

#include <memory>

namespace spherewalk::cli {

namespace {

struct ImportArguments {
    std::string survey;
    jobs::ImportOptions import;
};

Result importPictures(const ImportArguments& options, Context& context) {
    auto store = store::SurveyStore::open(options.survey, store::Access::Write);
    const jobs::ImportReport report =
        jobs::importPhotos(store, options.import, context.progress, context.stop);
    return {jobs::toJson(report),
            text("Imported ", counted(report.imported, "photo", "photos"), ", ", report.withRotation,
                 " with a rotation; ", counted(report.alreadyThere, "was", "were"), " there already; ",
                 counted(report.newStations, "station was", "stations were"),
                 " added for places that were not planned.",
                 report.moved == 0
                     ? ""
                     : text(" ", counted(report.moved, "was", "were"), " moved to another place."),
                 report.unknownPlaces > 0 ? " Where they were taken, align --positions free solves."
                 : report.imported == 0
                     ? ""
                     : " None of them was compared with its neighbours yet: review does that, and align.",
                 report.refused.empty()
                     ? ""
                     : text(" ", counted(report.refused.size(), "line was", "lines were"), " refused.")),
            report.refused.empty()};
}

} // namespace

void addImport(Commands& commands) {
    const auto options = std::make_shared<ImportArguments>();
    const program::Command command =
        commands.add("import", "Take photos from elsewhere into a survey",
                     [options](Context& context) { return importPictures(*options, context); });
    command.option("survey", options->survey, "Folder of the survey").required();
    command.option("--photos", options->import.photos, "Folder of the photos").required();
    command.option(
        "--positions", options->import.positions,
        "CSV with the columns file,x_m,y_m,z_m and optionally yaw_deg, or qw,qx,qy,qz (room from photo); "
        "without it: all JPEGs of the folder, whose places align --positions free solves");
    command
        .option("--tolerance", options->import.stationToleranceM,
                "Distance within which a photo belongs to a planned station, metres")
        .range(0.0, 10.0)
        .showDefault();
    command.flag("--move", options->import.move,
                 "Move photos that the survey has already to the places in the file");
}

} // namespace spherewalk::cli
