// SPDX-License-Identifier: GPL-3.0-or-later
// A reviewer finds what is wrong with a survey: photos that are blurred, dark, burnt out, show somebody, or
// are tagged with each other's places.
#include "../people/peopled_survey.h"
#include "shell/person.h"
#include "temporary_folder.h"
#include "ui/align/align_mode.h"
#include "ui/look/told_label.h"
#include "ui/review/review_mode.h"

#include "spherewalk/base/file.h"
#include "spherewalk/base/text.h"
#include "spherewalk/jobs/import_photos.h"
#include "spherewalk/jpeg/jpeg.h"
#include "spherewalk/practice/practice_room.h"

#include <QComboBox>
#include <QListView>

#include <cstdlib>
#include <set>

namespace spherewalk::ui {

namespace fs = std::filesystem;

namespace {

constexpr double kReadingS = 10; ///< To read a photo's sentence and to look where it points.
constexpr double kKeyS = 0.5;
constexpr double kMostS = 300;
constexpr int kMostKeys = 3; ///< A photo.

/// The same picture from a hand that turned by so many pixels.
RgbImage blurred(const RgbImage& picture, int px) {
    RgbImage result(picture.width(), picture.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            for (int channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int shift = 0; shift < px; ++shift) {
                    sum += picture.at((x + shift) % picture.width(), y)[channel];
                }
                result.at(x, y)[channel] = static_cast<std::uint8_t>(sum / px);
            }
        }
    }
    return result;
}

RgbImage brightened(RgbImage picture, double factor) {
    for (std::uint8_t& value : picture.values()) {
        value = static_cast<std::uint8_t>(std::min(255.0, factor * value));
    }
    return picture;
}

/// A grown-up who stands there.
std::vector<practice::PracticeObject> personAt(const Eigen::Vector2d& floorM) {
    using practice::PracticeObject;
    return {{PracticeObject::Shape::Box,
             {floorM.x(), floorM.y(), 0.73},
             {0.12, 0.21, 0.72},
             Radians(0.4),
             {60, 60, 110}},
            {PracticeObject::Shape::Sphere,
             {floorM.x(), floorM.y(), 1.62},
             Eigen::Vector3d::Constant(0.12),
             {},
             {205, 160, 130}}};
}

/// A practice room of which some photos are spoilt.
class SpoiltSurvey {
  public:
    SpoiltSurvey(int photos, double stepM) {
        m_options.stepM = stepM;
        m_options.mostPhotos = photos;
        m_photos = test::emptySurvey(m_options);
    }

    /// Spoils so many photos of each kind: blurred, dark, burnt out, with somebody in it; and swaps two tags.
    void spoil(int ofEach) {
        for (int i = 0; i < ofEach; ++i) {
            RgbImage& hasty = m_photos[next()].picture;
            hasty = blurred(hasty, 24);
            RgbImage& dark = m_photos[next()].picture;
            dark = brightened(std::move(dark), 0.08);
            RgbImage& burnt = m_photos[next()].picture;
            burnt = brightened(std::move(burnt), 8);
            showSomebody(m_photos[next()]);
        }
        std::swap(m_photos[next()].nominalM, m_photos[next()].nominalM);
    }

    fs::path write(const fs::path& folder) const {
        const practice::RoomPlan plan = practice::PracticeRoom().plan();
        survey::Room room;
        room.outline = plan.outline;
        room.obstacles = plan.obstacles;
        room.ceilingM = plan.ceilingM;
        auto store = store::SurveyStore::create(folder / "room.spherewalk", "room", room, {}, {});
        fs::create_directories(folder / "in");
        std::string csv = "file,x_m,y_m,z_m\n";
        for (std::size_t i = 0; i < m_photos.size(); ++i) {
            const Eigen::Vector3d& at = m_photos[i].nominalM;
            writeFile(folder / "in" / fileOf(i), jpeg::encode(m_photos[i].picture, 92));
            csv += text(fileOf(i), ",", fixed(at.x(), 4), ",", fixed(at.y(), 4), ",", fixed(at.z(), 4), "\n");
        }
        writeFile(folder / "p.csv", bytesOf(csv));
        jobs::importPhotos(store, {folder / "in", folder / "p.csv"}, noProgress(), {});
        return folder / "room.spherewalk";
    }

    static std::string fileOf(std::size_t photo) { return text("R", 1001 + photo, ".JPG"); }

    std::size_t size() const { return m_photos.size(); }

    std::set<std::string> badFiles() const {
        std::set<std::string> files;
        for (const int photo : m_bad) {
            files.insert(fileOf(static_cast<std::size_t>(photo)));
        }
        return files;
    }

  private:
    /// Takes the photo again with somebody where the cart stands another time, 1 to 2 m away.
    void showSomebody(test::PeopledPhoto& photo) const {
        const auto isNear = [&](const test::PeopledPhoto& other) {
            const double awayM = (other.nominalM - photo.nominalM).norm();
            return awayM > 1 && awayM < 2;
        };
        const auto place = std::ranges::find_if(m_photos, isNear);
        practice::PracticeRoomOptions room;
        room.objects = personAt(place->nominalM.head<2>());
        photo.picture = practice::PracticeRoom(room).spherical(
            photo.truth, {photo.picture.width(), photo.picture.height()});
    }

    /// Another photo that nothing is wrong with.
    std::size_t next() {
        do {
            m_last = (m_last + 7) % m_photos.size();
        } while (!m_bad.insert(static_cast<int>(m_last)).second);
        return m_last;
    }

    test::PeopledOptions m_options;
    std::vector<test::PeopledPhoto> m_photos;
    std::set<int> m_bad;
    std::size_t m_last = 3;
};

} // namespace

TEST(ReviewerTest, FindsEveryBadPhoto) {
    // Fourteen among 120 take some minutes; a part is tested each time.
    const bool isWhole = std::getenv("SPHEREWALK_REVIEWER") != nullptr;
    SpoiltSurvey spoilt(isWhole ? 120 : 30, isWhole ? 0.25 : 0.4);
    spoilt.spoil(isWhole ? 3 : 1);
    const std::set<std::string> bad = spoilt.badFiles();
    const test::TemporaryFolder folder;
    const fs::path path = spoilt.write(folder.path());

    Person person;
    ASSERT_TRUE(person.window().openSurvey(QString::fromStdString(path.string())));
    person.choose("Review");
    person.press("checkPhotos");
    person.waitForTasks();
    person.choose("Align");
    person.press("run");
    person.waitForTasks();

    // What is called doubtful, and what failed, one after the other.
    person.choose("Review");
    const int before = person.actions();
    const store::SurveyStore& store = person.window().session()->store();
    auto& list = person.widget<QListView>("stations");
    std::set<std::string> found;
    int most = 0;
    int looked = 0;
    for (const int downs : {2, 3}) {
        auto& filter = person.widget<QComboBox>("filter");
        filter.setFocus();
        person.key(filter, Qt::Key_Home);
        for (int i = 0; i < downs; ++i) {
            person.key(filter, Qt::Key_Down);
        }
        list.setFocus();
        person.key(list, Qt::Key_Home);
        for (int rows = list.model()->rowCount(); rows > 0; rows = list.model()->rowCount()) {
            const auto station = person.window().session()->selection()->current();
            ASSERT_TRUE(station);
            EXPECT_FALSE(person.widget<ToldLabel>("reasons").words().isEmpty());
            const std::string file = store.chosenPhoto(*station)->cameraFileName;
            const bool isBad = bad.contains(file);
            if (isBad) {
                found.insert(file);
            }
            const int keysBefore = person.actions();
            person.key(list, isBad ? Qt::Key_R : Qt::Key_A);
            person.waitUntil([&] { return list.model()->rowCount() < rows; });
            ASSERT_LT(list.model()->rowCount(), rows);
            most = std::max(most, person.actions() - keysBefore);
            ++looked;
        }
    }
    const double seconds = kReadingS * looked + kKeyS * (person.actions() - before);
    EXPECT_EQ(found, bad);
    EXPECT_LE(most, kMostKeys);
    EXPECT_LE(seconds, kMostS);
    std::printf("%zu photos, %zu bad, %zu found, %d looked at, %.0f s, at most %d key(s) a photo\n",
                spoilt.size(), bad.size(), found.size(), looked, seconds, most);
    person.window().close();
}

} // namespace spherewalk::ui
