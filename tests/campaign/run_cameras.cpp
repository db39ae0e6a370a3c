// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_cameras.h"

#include "fault_script.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jpeg/jpeg.h"

#include <algorithm>

namespace spherewalk::campaign {

namespace fs = std::filesystem;

std::optional<std::string> lookOf(const fs::path& jpeg) {
    try {
        const Bytes bytes = readFile(jpeg);
        constexpr std::string_view kExif("Exif\0\0", 6);
        Sha256 hash;
        for (const jpeg::Segment& segment : jpeg::segments(bytes, jpeg.string())) {
            const ByteView content = segment.content(bytes);
            if (segment.marker == jpeg::kApp1 && content.size() > kExif.size() &&
                std::equal(kExif.begin(), kExif.end(), content.begin(),
                           [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; })) {
                hash.update(content);
            }
        }
        hash.update(jpeg::decode(bytes, jpeg.string(), 8).values());
        return hash.hex();
    } catch (const Error&) {
        return std::nullopt;
    }
}

RunCameras::RunCameras(test::Random& random, fs::path folder, double timeScale, bool isDrawn)
    : m_random(random), m_folder(std::move(folder)), m_timeScale(timeScale), m_isDrawn(isDrawn) {
    add();
}

void RunCameras::add() {
    const fs::path folder = m_folder / text("camera-", m_cameras.size() + 1);
    fs::create_directory(folder);
    practice::PracticeCameraOptions options = randomCamera(m_random, folder);
    options.seed += 100'000 * m_cameras.size(); // another serial number, and other names of folders
    options.errors.seed = options.seed;
    options.timeScale = m_timeScale;
    options.isPlain = !m_isDrawn;
    options.threads = 1;
    m_cameras.push_back(
        {options.storageFolder, options.truthFile, std::make_unique<practice::PracticeCamera>(options)});
    m_cameras.back().camera->start();
}

std::string RunCameras::addressOf(std::size_t index) const {
    return text("127.0.0.1:", m_cameras[index].camera->port());
}

void RunCameras::change(const std::vector<Eigen::Vector3d>& places) {
    if (m_cameras.size() == 1) {
        add();
        const int old = m_random.integer(0, 3);
        for (int i = 0; i < old; ++i) {
            const int place = m_random.integer(0, static_cast<int>(places.size()) - 1);
            m_cameras.back().camera->setPosition(places[static_cast<std::size_t>(place)]);
            m_cameras.back().camera->befall({practice::FaultKind::ExtraPhoto, "", 0, 1, 0, 0});
        }
    }
    m_atHand = (m_atHand + 1) % m_cameras.size();
}

void RunCameras::disarm() {
    for (const Own& own : m_cameras) {
        own.camera->disarm();
    }
}

void RunCameras::stop() {
    for (const Own& own : m_cameras) {
        own.camera->stop();
    }
}

std::map<std::string, practice::Truth> RunCameras::truth() const {
    std::map<std::string, practice::Truth> all;
    for (const Own& own : m_cameras) {
        if (fs::exists(own.truthFile)) {
            for (practice::Truth& truth : practice::readTruth(own.truthFile)) {
                all.emplace(truth.sha256, std::move(truth));
            }
        }
    }
    return all;
}

std::optional<fs::path> RunCameras::fileOf(const practice::Truth& truth) const {
    for (const Own& own : m_cameras) {
        const fs::path file = own.storage / "100RICOH" / truth.file;
        if (fs::exists(file) && sha256HexOfFile(file) == truth.sha256) {
            return file;
        }
    }
    return std::nullopt;
}

void RunCameras::look() {
    for (const auto& [sha256, truth] : truth()) {
        if (m_isKnown[sha256]) {
            continue;
        }
        const auto file = fileOf(truth);
        const auto look = file ? lookOf(*file) : std::nullopt;
        if (look) {
            m_sha256ByLook.emplace(*look, sha256);
            m_isKnown[sha256] = true;
        }
    }
}

std::optional<std::string> RunCameras::sha256Of(const fs::path& jpeg) const {
    const auto look = lookOf(jpeg);
    const auto found = look ? m_sha256ByLook.find(*look) : m_sha256ByLook.end();
    return found == m_sha256ByLook.end() ? std::nullopt : std::optional(found->second);
}

} // namespace spherewalk::campaign
