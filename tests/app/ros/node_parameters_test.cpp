// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/node_parameters.h"
#include "expect_error.h"

#include <gtest/gtest.h>

#include <set>

namespace spherewalk::ros {

using test::expectError;

TEST(NodeParameters, AWholeNumberIsANumber) {
    NodeOptions options;
    assign("rate", std::int64_t{15}, options.rate);
    EXPECT_EQ(options.rate, 15);
    assign("rate", 7.5, options.rate);
    EXPECT_EQ(options.rate, 7.5);
    assign("threads", std::int64_t{2}, options.threads);
    EXPECT_EQ(options.threads, 2);
    assign("scene", std::string("depth"), options.scene);
    EXPECT_EQ(options.scene, "depth");
    assign("room_labels", std::vector<std::int64_t>{1, 7}, options.roomLabels);
    EXPECT_EQ(options.roomLabels, (std::vector<int>{1, 7}));
}

TEST(NodeParameters, OfAnotherKindAreNamed) {
    NodeOptions options;
    expectError(ErrorKind::InvalidInput, "rate must be a number",
                [&] { assign("rate", std::string("fast"), options.rate); });
    expectError(ErrorKind::InvalidInput, "rate must be a number",
                [&] { assign("rate", true, options.rate); });
    expectError(ErrorKind::InvalidInput, "threads must be a whole number",
                [&] { assign("threads", 1.5, options.threads); });
    expectError(ErrorKind::InvalidInput, "threads cannot be",
                [&] { assign("threads", std::int64_t{1} << 40, options.threads); });
    expectError(ErrorKind::InvalidInput, "scene must be a text",
                [&] { assign("scene", std::int64_t{3}, options.scene); });
    expectError(ErrorKind::InvalidInput, "room_labels must be a list",
                [&] { assign("room_labels", std::int64_t{1}, options.roomLabels); });
    expectError(ErrorKind::InvalidInput, "dataset must be a text",
                [&] { assign("dataset", GivenValue(), options.dataset); });
}

TEST(NodeParameters, HaveNamesAndDescriptionsOfTheirOwn) {
    NodeOptions options;
    std::set<std::string> names;
    std::set<std::string> descriptions;
    visitParameters(options, [&](const std::string& name, const std::string& description, auto&) {
        EXPECT_TRUE(names.insert(name).second) << name;
        EXPECT_TRUE(descriptions.insert(description).second) << description;
        EXPECT_GT(description.size(), 10U);
    });
    EXPECT_EQ(names.size(), 17U);
}

TEST(NodeParameters, ThatAreMissingAreNamed) {
    const auto start = [](const NodeOptions& options) {
        CameraNode node(
            options, [](const PublishedFrame&) {}, [](const std::string&) {});
    };
    NodeOptions options;
    expectError(ErrorKind::InvalidInput, "dataset is missing", [&] { start(options); });
    options.dataset = "/nowhere";
    expectError(ErrorKind::InvalidInput, "camera_info_url is missing", [&] { start(options); });
}

} // namespace spherewalk::ros
