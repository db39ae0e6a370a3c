// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "random.h"

#include "spherewalk/practice/practice_camera.h"
#include "spherewalk/practice/truth.h"

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace spherewalk::campaign {

/// What a picture is known by in whatever file it lies: its Exif data and its pixels. Tags, restart markers
/// and names do not count. Nothing for what is no picture.
std::optional<std::string> lookOf(const std::filesystem::path& jpeg);

/// The cameras of one run, of which one is at hand, and the truth of all.
class RunCameras {
  public:
    /// isDrawn: the pictures show the practice room.
    RunCameras(test::Random& random, std::filesystem::path folder, double timeScale, bool isDrawn);

    practice::PracticeCamera& atHand() { return *m_cameras[m_atHand].camera; }

    /// The address of the camera at hand, or of the other one.
    std::string address() const { return addressOf(m_atHand); }

    std::string otherAddress() const { return addressOf((m_atHand + 1) % m_cameras.size()); }

    std::size_t count() const { return m_cameras.size(); }

    /// The other camera is at hand from now on. One that joins so late has old photos.
    void change(const std::vector<Eigen::Vector3d>& places);
    void disarm();
    void stop();

    /// All pictures by their SHA-256.
    std::map<std::string, practice::Truth> truth() const;
    /// The file of a picture; nothing if the camera has it no more.
    std::optional<std::filesystem::path> fileOf(const practice::Truth& truth) const;
    /// Learns by what the pictures that are on the cameras now can be known; then sha256Of() knows them.
    void look();
    std::optional<std::string> sha256Of(const std::filesystem::path& jpeg) const;

  private:
    struct Own {
        std::filesystem::path storage;
        std::filesystem::path truthFile;
        std::unique_ptr<practice::PracticeCamera> camera;
    };

    std::string addressOf(std::size_t index) const;
    void add();

    test::Random& m_random;
    std::filesystem::path m_folder;
    double m_timeScale;
    bool m_isDrawn;
    std::vector<Own> m_cameras;
    std::size_t m_atHand = 0;
    std::map<std::string, std::string> m_sha256ByLook;
    std::map<std::string, bool> m_isKnown; ///< by SHA-256
};

} // namespace spherewalk::campaign
