// SPDX-License-Identifier: GPL-3.0-or-later
#include "spherewalk/base/error.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/compare_robot.h"
#include "spherewalk/jobs/looks.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/render/renderer.h"
#include "spherewalk/report/document.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace spherewalk::jobs {

namespace fs = std::filesystem;

namespace {

bool isPicture(const fs::path& file) {
    constexpr std::array<std::string_view, 3> kEndings{".png", ".jpg", ".jpeg"};
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

/// Pictures by their names without endings. Errors: InvalidInput for a name that two files have.
std::map<std::string, fs::path> byName(const std::vector<fs::path>& files) {
    std::map<std::string, fs::path> named;
    for (const fs::path& file : files) {
        const auto [at, isNew] = named.emplace(file.stem().string(), file);
        if (!isNew) {
            throw Error(ErrorKind::InvalidInput, text("Could not compare: ", at->second.string(), " and ",
                                                      file.string(), " have one name; rename one of them."));
        }
    }
    return named;
}

std::vector<fs::path> picturesIn(const fs::path& folder) {
    std::error_code failure;
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
        if (isPicture(entry.path())) {
            files.push_back(entry.path());
        }
    }
    if (failure) {
        throw Error(ErrorKind::NotFound,
                    text("Could not look for renderings in ", folder.string(), ": ", failure.message(), "."));
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// The rendering of each picture, and those that are left.
struct Matched {
    std::vector<fs::path> renderings;
    std::vector<std::string> unused;
};

Matched matched(const std::vector<RobotPicture>& pictures, const fs::path& folder) {
    std::map<std::string, fs::path> left = byName(picturesIn(folder));
    Matched result;
    std::vector<fs::path> files;
    std::vector<std::string> missing;
    for (const RobotPicture& picture : pictures) {
        files.push_back(picture.file);
        const auto found = left.find(picture.file.stem().string());
        if (found == left.end()) {
            missing.push_back(picture.file.stem().string());
            continue;
        }
        result.renderings.push_back(found->second);
    }
    byName(files);
    if (!missing.empty()) {
        throw Error(ErrorKind::NotFound,
                    text("Could not compare: ", folder.string(), " has no rendering called ", missing.front(),
                         missing.size() > 1 ? text(" (and lacks ", missing.size() - 1, " more)") : "",
                         "; name each rendering as its picture, with .png, .jpg or .jpeg."));
    }
    for (const fs::path& used : result.renderings) {
        left.erase(used.stem().string());
    }
    for (const auto& [name, file] : left) {
        result.unused.push_back(file.filename().string());
    }
    return result;
}

/// A photo that was left out is nowhere in the dataset.
void requireLeftOut(const render::DatasetInfo& dataset, const RobotPicture& picture) {
    constexpr double kSamePlaceM = 1e-6; // an export writes places exactly
    for (const render::DatasetPhoto& photo : dataset.photos) {
        if ((photo.roomFromPhoto.translation - picture.roomFromCamera.translation).norm() < kSamePlaceM) {
            throw Error(ErrorKind::InvalidInput,
                        text("Could not compare: the dataset has ", photo.file, " at the very place of ",
                             picture.file.filename().string(),
                             ", so our view would show that photo itself. Export the dataset with the same "
                             "--test-every as the pictures."));
        }
    }
}

RgbImage readRendering(const fs::path& file, const RgbImage& picture) {
    RgbImage rendering = photo::readPicture(file);
    if (rendering.width() != picture.width() || rendering.height() != picture.height()) {
        throw Error(ErrorKind::InvalidInput,
                    text("Could not compare: the rendering ", file.string(), " has ", rendering.width(),
                         " x ", rendering.height(), " pixels, its picture ", picture.width(), " x ",
                         picture.height(), "."));
    }
    return rendering;
}

std::vector<std::string> cells(const std::string& name, const Looks& ours, const Looks& theirs) {
    return {name,
            fixed(ours.psnrDb, 2),
            fixed(theirs.psnrDb, 2),
            fixed(ours.ssim, 3),
            fixed(theirs.ssim, 3),
            fixed(100 * ours.falseEdges, 1),
            fixed(100 * theirs.falseEdges, 1)};
}

std::string sentenceOf(const LooksBeside& beside) {
    const auto part = [](const PairedDifference& difference, double scale, int digits, const char* what) {
        return text(fixed(scale * difference.mean, digits), " +- ", fixed(scale * difference.margin, digits),
                    what);
    };
    return text("Picture by picture, theirs have an SSIM that is lower by ", part(beside.ssim, 1, 3, ""),
                ", and false edges that are more by ", part(beside.falseEdges, 100, 1, " %"), ".\n");
}

Json pairedJson(const PairedDifference& difference) {
    return {{"mean", difference.mean}, {"margin", difference.margin}};
}

} // namespace

RenderingsReport compareRenderings(const render::Renderer& renderer, const CameraModel& camera,
                                   const std::vector<RobotPicture>& pictures, const fs::path& renderings,
                                   const render::ViewOptions& view, ProgressSink& progress,
                                   const std::stop_token& stop) {
    if (pictures.empty()) {
        throw Error(ErrorKind::InvalidInput, "There are no pictures to compare renderings with.");
    }
    for (const RobotPicture& picture : pictures) {
        requireLeftOut(renderer.dataset().info(), picture);
    }
    Matched found = matched(pictures, renderings);
    RenderingsReport report;
    std::vector<Looks> ours;
    std::vector<Looks> theirs;
    render::ViewOptions options = view;
    options.correctsColour = false;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        throwIfStopped(stop);
        const RgbImage truth = readRobotPicture(pictures[i], camera);
        const RgbImage rendering = readRendering(found.renderings[i], truth);
        const std::vector<compare::PictureLine> lines = compare::straightLines(truth);
        const RgbImage own = renderer.render(camera, pictures[i].roomFromCamera, options).picture;
        ours.push_back(looksOf(truth, lines, own));
        theirs.push_back(looksOf(truth, lines, rendering));
        report.pictures.push_back({pictures[i].file, found.renderings[i], ours.back(), theirs.back()});
        progress.progress(static_cast<double>(i + 1) / static_cast<double>(pictures.size()),
                          text("Comparing picture ", i + 1, " of ", pictures.size()));
    }
    report.ours = summaryOf(ours);
    report.theirs = summaryOf(theirs);
    report.theirsBesideOurs = looksBeside(theirs, ours);
    report.unused = std::move(found.unused);
    return report;
}

std::string renderingsText(const RenderingsReport& report) {
    report::Table table{
        {"picture", "PSNR dB ours", "theirs", "SSIM ours", "theirs", "false edges % ours", "theirs"}, {}, 1};
    for (const ComparedRendering& picture : report.pictures) {
        table.rows.push_back(cells(picture.picture.filename().string(), picture.ours, picture.theirs));
    }
    table.rows.push_back(cells("mean", report.ours.mean, report.theirs.mean));
    std::string words = table.text();
    words += report.theirsBesideOurs ? sentenceOf(*report.theirsBesideOurs) : "";
    if (!report.unused.empty()) {
        words += text("No picture is called like ", report.unused.front(),
                      report.unused.size() > 1 ? text(" and ", report.unused.size() - 1, " more") : "",
                      ", so that was not compared.\n");
    }
    return words;
}

Json toJson(const RenderingsReport& report) {
    Json pictures = Json::array();
    for (const ComparedRendering& picture : report.pictures) {
        pictures.push_back({{"picture", picture.picture.filename().string()},
                            {"rendering", picture.rendering.string()},
                            {"ours", toJson(picture.ours)},
                            {"theirs", toJson(picture.theirs)}});
    }
    Json beside;
    if (report.theirsBesideOurs) {
        beside = {{"ssim_lower_by", pairedJson(report.theirsBesideOurs->ssim)},
                  {"false_edges_higher_by", pairedJson(report.theirsBesideOurs->falseEdges)}};
    }
    return {{"pictures", pictures},
            {"ours", toJson(report.ours.mean)},
            {"theirs", toJson(report.theirs.mean)},
            {"theirs_beside_ours", beside},
            {"unused", report.unused}};
}

} // namespace spherewalk::jobs
