// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_reader.h"
#include "temporary_folder.h"

#include "spherewalk/base/digest.h"
#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/base/text.h"
#include "spherewalk/geometry/equirect.h"
#include "spherewalk/jobs/export_foreign.h"
#include "spherewalk/jobs/export_place.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/photo/picture_file.h"
#include "spherewalk/practice/practice_room.h"
#include "spherewalk/practice/theta_jpeg.h"
#include "spherewalk/render/dataset.h"
#include "spherewalk/store/survey_store.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

namespace spherewalk::jobs {
namespace {

namespace fs = std::filesystem;

/// Hardly anything else in the room has such colours, and no blurred region keeps them.
bool isSecret(int red, int green, int blue) {
    constexpr int kApart = 110;
    return std::min(red, blue) - green > kApart || green - std::max(red, blue) > kApart;
}

std::size_t secretsIn(const RgbImage& picture) {
    std::size_t count = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const std::uint8_t* colour = picture.at(x, y);
            count += isSecret(colour[0], colour[1], colour[2]) ? 1 : 0;
        }
    }
    return count;
}

Bytes fromBase64(std::string_view letters) {
    constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    Bytes bytes;
    std::uint32_t group = 0;
    unsigned bits = 0;
    for (const char letter : letters) {
        const std::size_t value = kLetters.find(letter);
        if (value == std::string_view::npos) {
            break;
        }
        group = group << 6U | static_cast<std::uint32_t>(value);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes.push_back(static_cast<std::uint8_t>(group >> bits & 0xFFU));
        }
    }
    return bytes;
}

/// Secrets in every JPEG that begins somewhere in the bytes: a photo, its thumbnail in Exif, one in a script.
std::size_t secretsInJpegs(ByteView bytes) {
    std::size_t count = 0;
    for (std::size_t i = 0; i + 3 < bytes.size(); ++i) {
        if (bytes[i] == 0xFF && bytes[i + 1] == 0xD8 && bytes[i + 2] == 0xFF) {
            try {
                count += secretsIn(jpeg::decode(bytes.subspan(i), "a part of a file"));
            } catch (const Error&) { // these three bytes begin no picture
                continue;
            }
        }
    }
    return count;
}

/// Of COLOR_0 in a binary glTF: four numbers of 16 bits a vertex, in linear light.
std::size_t secretsInGlb(ByteView file) {
    constexpr std::size_t kHeader = 20;
    const auto word = [&](std::size_t at) {
        return static_cast<std::size_t>(file[at] | file[at + 1] << 8 | file[at + 2] << 16 |
                                        file[at + 3] << 24);
    };
    const std::size_t jsonBytes = word(12);
    const Json json = parseJson(textOf(file.subspan(kHeader, jsonBytes)), "the glb");
    const Json& accessor =
        json["accessors"][json["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"].get<std::size_t>()];
    const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const std::size_t first = kHeader + jsonBytes + 8 + view["byteOffset"].get<std::size_t>();
    const auto value = [&](std::size_t at) {
        const double linear = (file[at] | file[at + 1] << 8) / 65535.0;
        return static_cast<int>(255 * std::pow(linear, 1 / 2.2));
    };
    std::size_t count = 0;
    for (std::size_t i = 0; i < accessor["count"].get<std::size_t>(); ++i) {
        const std::size_t at = first + 8 * i;
        count += isSecret(value(at), value(at + 2), value(at + 4)) ? 1 : 0;
    }
    return count;
}

std::size_t secretsInObj(const std::string& obj) {
    std::istringstream lines(obj);
    std::string line;
    std::size_t count = 0;
    while (std::getline(lines, line)) {
        std::istringstream numbers(line);
        std::string kind;
        double x = 0;
        double y = 0;
        double z = 0;
        std::array<double, 3> colour{};
        if (numbers >> kind && kind == "v" && numbers >> x >> y >> z >> colour[0] >> colour[1] >> colour[2]) {
            const auto byte = [&](std::size_t i) { return static_cast<int>(255 * colour[i]); };
            count += isSecret(byte(0), byte(1), byte(2)) ? 1 : 0;
        }
    }
    return count;
}

std::size_t secretsInFile(const fs::path& file) {
    const Bytes bytes = readFile(file);
    std::size_t count = secretsInJpegs(bytes);
    const std::string_view content = textOf(bytes);
    for (std::size_t at = content.find("/9j/"); at != std::string_view::npos;
         at = content.find("/9j/", at + 4)) {
        count += secretsInJpegs(fromBase64(content.substr(at)));
    }
    if (file.extension() == ".png") {
        count += secretsIn(photo::readPicture(file));
    } else if (file.extension() == ".glb") {
        count += secretsInGlb(bytes);
    } else if (file.extension() == ".obj") {
        count += secretsInObj(readTextFile(file));
    } else if (file.extension() == ".ply") {
        for (const test::PlyVertex& vertex : test::readPly(file).vertices) {
            count += isSecret(vertex.colour[0], vertex.colour[1], vertex.colour[2]) ? 1 : 0;
        }
    }
    return count;
}

std::vector<fs::path> filesIn(const fs::path& folder) {
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) {
            files.push_back(entry.path());
        }
    }
    return files;
}

std::size_t secretsInFolder(const fs::path& folder) {
    std::size_t count = 0;
    for (const fs::path& file : filesIn(folder)) {
        count += secretsInFile(file);
    }
    return count;
}

/// A survey of the practice room by a Theta V. Every photo shows the same stripes before the wall, to the
/// left of its middle.
class PrivateExport : public testing::Test {
  protected:
    PrivateExport() {
        const practice::PracticeRoom practice;
        const practice::RoomPlan drawn = practice.plan();
        survey::Room room;
        room.outline = drawn.outline;
        room.ceilingM = drawn.ceilingM;
        const survey::PlanOptions options;
        auto store = store::SurveyStore::create(m_path, "room", room, options, survey::plan(room, options));
        fs::create_directories(m_folder / "in");
        std::string csv = "file,x_m,y_m,z_m,yaw_deg\n";
        for (int i = 0; i < 4; ++i) {
            const Eigen::Vector3d at(2 + 0.4 * (i % 2), 1.8 + 0.4 * (i / 2),
                                     1.3); // NOLINT(bugprone-integer-division)
            RgbImage picture = practice.spherical({Eigen::Quaterniond::Identity(), at}, kSize);
            drawStripes(at, picture);
            const std::string name = text("R", 1001 + i, ".JPG");
            practice::ThetaTags tags;
            tags.time = std::chrono::system_clock::time_point(std::chrono::hours(500000 + i));
            writeFile(m_folder / "in" / name, practice::thetaJpeg(picture, tags));
            csv += text(name, ",", at.x(), ",", at.y(), ",", at.z(), ",0\n");
        }
        writeFile(m_folder / "p.csv", bytesOf(csv));
        importPhotos(store, {m_folder / "in", m_folder / "p.csv"}, noProgress(), {});
    }

    void markStripes() const {
        auto store = store::SurveyStore::open(m_path, store::Access::Write);
        for (const store::PhotoRecord& photo : store.photos()) {
            store.markRegion(photo.id, regionFrom(photo.positionM));
        }
    }

    store::SurveyStore open() const { return store::SurveyStore::open(m_path, store::Access::Read); }

    /// Secrets in what each format writes.
    std::map<std::string, std::size_t> exported(const std::string& prefix) {
        std::map<std::string, std::size_t> secrets;
        const auto look = [&](const std::string& format, const auto& write) {
            const fs::path out = m_folder / text(prefix, format);
            write(out);
            secrets[format] = secretsInFolder(out);
            for (const fs::path& file : filesIn(out)) {
                EXPECT_FALSE(m_isMarked && m_originals.contains(sha256HexOfFile(file))) << file;
            }
        };
        for (const store::PhotoRecord& photo : open().photos()) {
            m_originals.insert(photo.fileSha256);
            m_originals.insert(photo.cameraSha256);
        }
        ExportOptions depth;
        depth.scene = render::SceneKind::Depth;
        look("spherewalk", [&](const fs::path& out) { exportDataset(open(), out, depth, noProgress(), {}); });
        for (const auto format :
             {dataset::PoseFormat::Tum, dataset::PoseFormat::Kitti, dataset::PoseFormat::Euroc,
              dataset::PoseFormat::Colmap, dataset::PoseFormat::Nerfstudio}) {
            ForeignOptions options;
            options.format = format;
            look(std::string(name(format)),
                 [&](const fs::path& out) { exportForeign(open(), out, options, noProgress(), {}); });
        }
        for (const auto format : {PlaceFormat::Ply, PlaceFormat::Gltf, PlaceFormat::Obj}) {
            PlaceOptions options;
            options.formats = {format};
            options.fusion.voxelM = 0.04;
            look(text("place", static_cast<int>(format)),
                 [&](const fs::path& out) { exportPlace(m_path, out, options, noProgress(), {}); });
        }
        look("web", [&](const fs::path& out) { exportWeb(m_path, out, {}, noProgress(), {}); });
        return secrets;
    }

    static constexpr EquirectSize kSize{1024, 512};
    inline static const Eigen::Vector3d kMiddle{2.2, 4, 1.3}; ///< Of the stripes.

    static survey::PrivateRegion regionFrom(const Eigen::Vector3d& at) {
        return survey::regionAround(kMiddle - at, Degrees(50), Degrees(50));
    }

    test::TemporaryFolder m_folder;
    fs::path m_path = m_folder / "room.spherewalk";
    std::set<std::string> m_originals;
    bool m_isMarked = false;

  private:
    /// On the northern wall, 1.6 m wide and high, with stripes of 20 cm.
    static void drawStripes(const Eigen::Vector3d& at, RgbImage& picture) {
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const Eigen::Vector3d ray = direction(kSize, Eigen::Vector2d(x, y));
                const Eigen::Vector3d aside = (kMiddle.y() - at.y()) / ray.y() * ray + at - kMiddle;
                if (ray.y() > 0 && std::abs(aside.x()) < 0.8 && std::abs(aside.z()) < 0.8) {
                    const bool isGreen = static_cast<int>((aside.x() + 0.8) / 0.2) % 2 == 0;
                    picture.at(x, y)[0] = isGreen ? 0 : 255;
                    picture.at(x, y)[1] = isGreen ? 255 : 0;
                    picture.at(x, y)[2] = isGreen ? 0 : 255;
                }
            }
        }
    }
};

} // namespace

TEST_F(PrivateExport, ShowsNoFormatWhatIsPrivate) {
    auto sharp = exported("sharp-");
    for (const auto& [format, secrets] : sharp) {
        EXPECT_GT(secrets, 20U) << format << " shows what nobody has marked";
    }
    markStripes();
    m_isMarked = true;
    for (const auto& [format, secrets] : exported("blurred-")) {
        EXPECT_LE(secrets, sharp[format] / 200) << format;
    }
    const auto dataset = render::Dataset::open(m_folder / "blurred-spherewalk");
    for (const render::DatasetPhoto& photo : dataset.info().photos) {
        EXPECT_EQ(photo.blurredRegions, 1);
    }
    EXPECT_GT(secretsInFolder(open().photoFolder()), 1000U) << "the survey keeps the originals";
}

TEST_F(PrivateExport, LeavesPhotosWithoutRegionsAsTheyWere) {
    const auto photosIn = [&](const char* name) {
        std::map<std::string, std::string> hashes;
        for (const fs::path& file : filesIn(m_folder / name / "photos")) {
            hashes.emplace(file.filename(), sha256HexOfFile(file));
        }
        return hashes;
    };
    exportDataset(open(), m_folder / "before", {}, noProgress(), {});
    {
        auto store = store::SurveyStore::open(m_path, store::Access::Write);
        const survey::PrivateRegion region = regionFrom(store.photos()[0].positionM);
        store.markRegion(store.photos()[0].id, region);
        store.setFoundRegions(store.photos()[1].id, {region}, 1);
        store.removeRegion(store.regions(store.photos()[1].id)[0].id);
    }
    const ExportReport report = exportDataset(open(), m_folder / "after", {}, noProgress(), {});
    EXPECT_EQ(report.written.blurredPhotos, 1U);
    EXPECT_EQ(report.written.blurredRegions, 1U);
    auto before = photosIn("before");
    auto after = photosIn("after");
    EXPECT_NE(before["R1001.jpg"], after["R1001.jpg"]);
    EXPECT_EQ(before["R1002.jpg"], after["R1002.jpg"]) << "what a person has rejected is not blurred";
    EXPECT_EQ(before["R1003.jpg"], after["R1003.jpg"]);
}

} // namespace spherewalk::jobs
