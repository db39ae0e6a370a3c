// SPDX-License-Identifier: Apache-2.0
#include "temporary_folder.h"
#include "test_dataset.h"

#include "spherewalk/base/error.h"
#include "spherewalk/base/file.h"
#include "spherewalk/base/json.h"
#include "spherewalk/render/dataset_format.h"

#include <gtest/gtest.h>

#include <set>

namespace spherewalk::render {

namespace {

std::set<std::string> keysOf(const Json& object) {
    std::set<std::string> keys;
    for (const auto& [key, value] : object.items()) {
        keys.insert(key);
    }
    return keys;
}

std::set<std::string> names(const Json& list) {
    return {list.begin(), list.end()};
}

/// The schema knows every member that we write, and we write every member that it requires.
void expectAgreement(const Json& schema, const Json& written) {
    EXPECT_EQ(keysOf(schema["properties"]), keysOf(written));
    const std::set<std::string> keys = keysOf(written);
    for (const std::string& required : names(schema["required"])) {
        EXPECT_TRUE(keys.contains(required)) << required;
    }
}

} // namespace

// A dataset without any one member that the schema requires is refused, and one without an optional member is
// read.
TEST(DatasetSchema, AgreesWithWhatIsWrittenAndWhatIsRequired) {
    const Json schema = parseJson(readTextFile(SPHEREWALK_DATASET_SCHEMA), "schema");
    const test::TemporaryFolder folder;
    const Json dataset =
        toJson(test::writeTestDataset(folder.path(), {Rigid3{}}, test::smoothWorld, 64, 2.0));
    expectAgreement(schema, dataset);
    const Json& photo = schema["$defs"]["photo"];
    expectAgreement(photo, dataset["photos"][0]);
    const auto isRead = [](const Json& json) {
        try {
            parseDatasetInfo(json, "x");
            return true;
        } catch (const Error& /*refused*/) {
            return false;
        }
    };
    for (const std::string& key : keysOf(dataset)) {
        Json without = dataset;
        without.erase(key);
        EXPECT_EQ(isRead(without), !names(schema["required"]).contains(key)) << key;
    }
    for (const std::string& key : keysOf(dataset["photos"][0])) {
        Json without = dataset;
        without["photos"][0].erase(key);
        EXPECT_EQ(isRead(without), !names(photo["required"]).contains(key)) << key;
    }
}

} // namespace spherewalk::render
