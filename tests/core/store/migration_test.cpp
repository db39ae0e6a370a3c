// SPDX-License-Identifier: GPL-3.0-or-later
#include "database.h"
#include "survey_fixture.h"

#include <array>

namespace spherewalk::store {

namespace fs = std::filesystem;

namespace {

class Migrations : public testing::Test {
  protected:
    void SetUp() override {
        Database database = open(Database::Mode::Create);
        makeSchema(database, kFirst);
        database.execute("INSERT INTO note VALUES ('kept')");
    }

    Database open(Database::Mode mode = Database::Mode::Write) const {
        return {m_file, mode, std::chrono::seconds(1)};
    }

    static std::string noteIn(const Database& database) {
        Statement row = database.query("SELECT text FROM note");
        return row.step() ? row.text(0) : "";
    }

    static constexpr std::array kFirst{Migration{1, "CREATE TABLE note (text TEXT NOT NULL) STRICT"}};
    static constexpr Migration kSecond{2, "ALTER TABLE note ADD COLUMN stars INTEGER NOT NULL DEFAULT 3"};
    static constexpr Migration kThird{3, "CREATE TABLE tag (name TEXT) STRICT; UPDATE note SET stars = 5"};
    static constexpr Migration kBroken{3, "CREATE TABLE tag (name TEXT) STRICT; UPDATE note SET nothing = 5"};

    spherewalk::test::TemporaryFolder m_folder;
    fs::path m_file = m_folder / "survey.sqlite";
};

} // namespace

TEST_F(Migrations, BringAnOlderSurveyUpToDateStepByStep) {
    Database database = open();
    migrate(database, std::array{kFirst[0], kSecond, kThird});
    EXPECT_EQ(identity(database).version, 3);
    EXPECT_EQ(identity(database).applicationId, kApplicationId);
    EXPECT_EQ(noteIn(database), "kept");
    EXPECT_EQ(database.integer("SELECT stars FROM note"), 5);
}

TEST_F(Migrations, KeepACopyOfTheDatabaseAsItWas) {
    {
        Database database = open();
        database.execute("INSERT INTO note VALUES ('still in the journal')");
        migrate(database, std::array{kFirst[0], kSecond});
    }
    const Database copy(m_folder / "survey.sqlite.before-v2", Database::Mode::Read, std::chrono::seconds(1));
    EXPECT_EQ(identity(copy).version, 1);
    EXPECT_EQ(copy.integer("SELECT count(*) FROM note"), 2);
    EXPECT_FALSE(copy.query("SELECT 1 FROM pragma_table_info('note') WHERE name = 'stars'").step());
    EXPECT_FALSE(fs::exists(m_folder / "survey.sqlite.before-v2.part"));
}

TEST_F(Migrations, DoNothingToASurveyThatIsUpToDate) {
    Database database = open();
    migrate(database, kFirst);
    EXPECT_FALSE(fs::exists(m_folder / "survey.sqlite.before-v1"));
}

TEST_F(Migrations, StopAtTheLastVersionThatWorked) {
    Database database = open();
    spherewalk::test::expectError(ErrorKind::Corrupt, "its tables are not those of a survey", [&] {
        migrate(database, std::array{kFirst[0], kSecond, kBroken});
    });
    EXPECT_EQ(identity(database).version, 2);
    EXPECT_FALSE(database.query("SELECT 1 FROM sqlite_schema WHERE name = 'tag'").step());
    EXPECT_EQ(noteIn(database), "kept");
    // And go on from there when they can, over the copy of the first try.
    migrate(database, std::array{kFirst[0], kSecond, kThird});
    EXPECT_EQ(identity(database).version, 3);
}

TEST_F(Migrations, AreNumberedWithoutGaps) {
    int expected = 1;
    for (const Migration& migration : migrations()) {
        EXPECT_EQ(migration.version, expected++);
    }
}

TEST(Schema, IsStrictDurableAndMarked) {
    const spherewalk::test::TemporaryFolder folder;
    test::createSurvey(folder / "x.spherewalk");
    Database database(folder / "x.spherewalk" / "survey.sqlite", Database::Mode::Write,
                      std::chrono::seconds(1));
    EXPECT_EQ(identity(database).applicationId, 0x53706857);
    EXPECT_EQ(identity(database).version, newestVersion(migrations()));
    EXPECT_EQ(database.integer("PRAGMA synchronous"), 2);
    EXPECT_EQ(database.integer("PRAGMA foreign_keys"), 1);
    Statement mode = database.query("PRAGMA journal_mode");
    ASSERT_TRUE(mode.step());
    EXPECT_EQ(mode.text(0), "wal");
    EXPECT_EQ(database.integer("SELECT count(*) FROM pragma_table_list WHERE type = 'table' AND NOT strict "
                               "AND name NOT LIKE 'sqlite%'"),
              0);
    EXPECT_GE(database.integer("SELECT count(*) FROM pragma_table_list WHERE strict"), 9);
}

} // namespace spherewalk::store
