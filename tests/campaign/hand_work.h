// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "run_cameras.h"

#include "spherewalk/base/json.h"
#include "spherewalk/store/survey_store.h"

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace spherewalk::campaign {

/// What a command has said.
struct Answer {
    int status = 0;
    std::string output;
    std::string errors;
};

/// What people do to a survey by hand, at times wrongly: import and retag photos, and decide on shots. They
/// know where pictures were taken, because the truth tells them.
class HandWork {
  public:
    HandWork(std::string cli, RunCameras& cameras, test::Random& random, std::filesystem::path folder,
             Json exposure);

    /// Imports some pictures that lie on the cameras. Some lines of the list are wrong.
    void import(const std::filesystem::path& survey);
    /// Moves a photo to any station.
    void retag(const std::filesystem::path& survey);
    void align(const std::filesystem::path& survey);
    /// Decides on shots by the commands that the program names. isLast: nobody waits for a picture any more.
    void decide(const std::filesystem::path& survey, bool isLast);
    /// Puts right what was done wrongly.
    void correct(const std::filesystem::path& survey);

    /// Says that a camera was brought to another place than the one that was asked for.
    void noteWrongPlace(const Eigen::Vector3d& saidM, const Eigen::Vector3d& trueM) {
        m_wrong.emplace_back(saidM, trueM);
    }

    /// Whether people have given this photo a place that is not its own.
    bool isWrongOnPurpose(const Eigen::Vector3d& saidM, const Eigen::Vector3d& trueM) const;

    /// How many shots people gave up, by station.
    const std::map<std::string, int>& givenUp() const { return m_givenUp; }

    /// How often what was done.
    const std::map<std::string, int>& counts() const { return m_counts; }

    const std::vector<std::string>& violations() const { return m_violations; }

    Answer run(const std::vector<std::string>& words);

  private:
    struct Line {
        std::string file;
        Eigen::Vector3d positionM;
        Eigen::Quaterniond roomFromPhoto;
    };

    std::vector<practice::Truth> picturesOnCameras() const;
    std::filesystem::path writeLines(const std::vector<Line>& lines, bool withRotations);
    void importLines(const std::filesystem::path& survey, const std::vector<Line>& lines, bool withRotations,
                     bool move);
    void retagTo(const std::filesystem::path& survey, const store::PhotoRecord& photo,
                 const store::StationRecord& station);
    Eigen::Vector3d somePlace(const std::vector<store::StationRecord>& stations);
    bool isOfStation(const survey::Shot& shot, const Eigen::Vector3d& placeM) const;
    void giveUp(const std::filesystem::path& survey, const survey::Shot& shot, const std::string& station,
                const std::string& said);

    std::string m_cli;
    RunCameras& m_cameras;
    test::Random& m_random;
    std::filesystem::path m_stick; ///< A memory stick with pictures that were copied from the cameras.
    Json m_exposure;
    std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> m_wrong; ///< What was said, and what is true.
    std::map<std::string, int> m_givenUp;
    std::map<std::string, int> m_counts;
    std::vector<std::string> m_violations;
};

} // namespace spherewalk::campaign
