// SPDX-License-Identifier: GPL-3.0-or-later
// Takes surveys with a practice camera while everything goes wrong that can, and compares each with the
// camera's own truth at the end. Usage: spherewalk_campaign CLI [--runs N] [--first SEED] [--jobs N]
// [--minutes N] [--keep FOLDER]
#include "campaign_run.h"
#include "fault_script.h"
#include "program.h"
#include "temporary_folder.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <mutex>
#include <string_view>
#include <thread>

namespace spherewalk::campaign {

namespace {

struct Options {
    std::string cli;
    unsigned runs = 500;
    unsigned first = 1;
    unsigned jobs = 4;
    unsigned minutes = 24 * 60; ///< No run begins later.
    std::string keepIn;         ///< A folder for what runs leave that broke a rule.
};

Options parse(const std::vector<std::string>& words) {
    Options options;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto number = [&] { return static_cast<unsigned>(std::stoul(words.at(++i))); };
        if (words[i] == "--runs") {
            options.runs = number();
        } else if (words[i] == "--first") {
            options.first = number();
        } else if (words[i] == "--jobs") {
            options.jobs = number();
        } else if (words[i] == "--minutes") {
            options.minutes = number();
        } else if (words[i] == "--keep") {
            options.keepIn = words.at(++i);
        } else {
            options.cli = words[i];
        }
    }
    return options;
}

/// Five stations, enough for each fault to meet a shot before and after it.
std::filesystem::path makeSurvey(const std::string& cli, const std::filesystem::path& folder) {
    const std::filesystem::path survey = folder / "template.spherewalk";
    test::Program program(
        {cli, "new", survey.string(), "--rect", "0,0,2,1.6", "--ceiling", "2.6", "--step", "0.6"});
    if (program.wait() != 0) {
        throw std::runtime_error("could not make a survey: " + program.errors());
    }
    return survey;
}

/// A sentence if no run has met the fault that could give a station another place's picture. A campaign of
/// few runs need not meet it.
std::string notMet(const std::vector<RunReport>& reports) {
    constexpr std::size_t kEnoughRuns = 20;
    const bool isMet = std::ranges::any_of(
        reports, [](const RunReport& report) { return report.faults.contains(kButtonInDoubt); });
    return isMet || reports.size() < kEnoughRuns
               ? ""
               : "nobody carried the cart on and pressed the button while a shot was in doubt";
}

void print(const std::vector<RunReport>& reports) {
    RunReport sum;
    int violations = 0;
    for (const RunReport& report : reports) {
        for (const auto& [name, count] : report.faults) {
            sum.faults[name] += count;
        }
        for (const auto& [name, count] : report.deeds) {
            sum.deeds[name] += count;
        }
        sum.programs += report.programs;
        sum.kills += report.kills;
        sum.powerCycles += report.powerCycles;
        sum.stopSeconds.insert(sum.stopSeconds.end(), report.stopSeconds.begin(), report.stopSeconds.end());
        sum.findings.photos += report.findings.photos;
        sum.findings.exposures += report.findings.exposures;
        sum.findings.buttonPictures += report.findings.buttonPictures;
        sum.findings.toldShots += report.findings.toldShots;
        sum.findings.datasetPhotos += report.findings.datasetPhotos;
        violations += static_cast<int>(report.findings.violations.size());
    }
    std::sort(sum.stopSeconds.begin(), sum.stopSeconds.end());
    std::cout << "runs " << reports.size() << "\nprograms " << sum.programs << "\nkilled " << sum.kills
              << "\npower cycles " << sum.powerCycles << "\nexposures asked for " << sum.findings.exposures
              << "\npictures by the button " << sum.findings.buttonPictures << "\nphotos in the surveys "
              << sum.findings.photos << "\nshots that a person was told of " << sum.findings.toldShots
              << "\nphotos of datasets that were known by their pictures " << sum.findings.datasetPhotos
              << "\n";
    if (!sum.stopSeconds.empty()) {
        const auto late = std::count_if(sum.stopSeconds.begin(), sum.stopSeconds.end(),
                                        [](double seconds) { return seconds > 0.2; });
        std::cout << "stopped by Ctrl-C " << sum.stopSeconds.size() << ", median "
                  << sum.stopSeconds[sum.stopSeconds.size() / 2] << " s, longest " << sum.stopSeconds.back()
                  << " s, " << late << " above 0.2 s\n";
    }
    for (const auto& [name, count] : sum.deeds) {
        std::cout << name << " " << count << "\n";
    }
    for (const auto& [name, count] : sum.faults) {
        std::cout << "fault " << name << " " << count << "\n";
    }
    std::cout << "violations " << violations << std::endl;
    if (const std::string missing = notMet(reports); !missing.empty()) {
        std::cout << missing << std::endl;
    }
}

int runAll(const Options& options) {
    ::setenv("SPHEREWALK_CAMERA_USER", kUser, 1);
    ::setenv("SPHEREWALK_CAMERA_PASSWORD", kPassword, 1);
    const test::TemporaryFolder folder;
    const std::filesystem::path survey = makeSurvey(options.cli, folder.path());
    std::vector<RunReport> reports;
    std::atomic<unsigned> next = 0;
    std::mutex mutex;
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(options.minutes);
    const auto work = [&] {
        for (unsigned i = next++; i < options.runs && std::chrono::steady_clock::now() < end; i = next++) {
            RunReport report;
            try {
                report = run({options.cli, survey, options.first + i, options.keepIn});
            } catch (const std::exception& failure) {
                report.seed = options.first + i;
                report.findings.violations.push_back(failure.what());
            }
            const std::scoped_lock lock(mutex);
            for (const std::string& violation : report.findings.violations) {
                std::cout << "seed " << report.seed << ": " << violation << std::endl;
            }
            reports.push_back(std::move(report));
            std::cerr << reports.size() << " of " << options.runs << " runs have ended\n";
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned i = 0; i < std::max(1U, options.jobs); ++i) {
            threads.emplace_back(work);
        }
    }
    print(reports);
    return notMet(reports).empty() &&
                   std::all_of(reports.begin(), reports.end(),
                               [](const RunReport& report) { return report.findings.violations.empty(); })
               ? 0
               : 1;
}

} // namespace

} // namespace spherewalk::campaign

int main(int argc, char** argv) {
    try {
        return spherewalk::campaign::runAll(spherewalk::campaign::parse({argv + 1, argv + argc}));
    } catch (const std::exception& failure) {
        std::cerr << failure.what() << "\n";
        return 2;
    }
}
