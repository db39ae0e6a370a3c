// SPDX-License-Identifier: GPL-3.0-or-later
#include "expect_error.h"
#include "ply_reader.h"

#include "spherewalk/base/json.h"
#include "spherewalk/place/surface_files.h"

#include <gtest/gtest.h>

#include <sstream>

namespace spherewalk::place {
namespace {

Surface twoTriangles(const Eigen::Vector3d& originM = Eigen::Vector3d::Zero()) {
    Surface surface;
    for (const Eigen::Vector3d& at : {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(1.25, 0, 0),
                                      Eigen::Vector3d(1.25, 2, 0.5), Eigen::Vector3d(0, 2, 0.5)}) {
        SurfaceVertex vertex;
        vertex.pInRoom = originM + at;
        vertex.normal = Eigen::Vector3f(0.6F, 0, 0.8F);
        vertex.colour = {10, 128, static_cast<std::uint8_t>(50 * surface.vertices.size())};
        vertex.photos = 3;
        vertex.confidence = 0.75F;
        surface.vertices.push_back(vertex);
    }
    surface.triangles = {{0, 1, 2}, {0, 2, 3}};
    return surface;
}

/// The JSON and the binary chunk of a .glb.
struct Glb {
    explicit Glb(const Bytes& bytes) {
        EXPECT_EQ(textOf(ByteView(bytes).first(4)), "glTF");
        EXPECT_EQ(number(bytes, 4), 2U);
        EXPECT_EQ(number(bytes, 8), bytes.size());
        const std::uint32_t jsonSize = number(bytes, 12);
        EXPECT_EQ(jsonSize % 4, 0U);
        EXPECT_EQ(textOf(ByteView(bytes).subspan(16, 4)), "JSON");
        json = parseJson(textOf(ByteView(bytes).subspan(20, jsonSize)), "the glTF");
        const std::size_t begin = 20 + jsonSize;
        EXPECT_EQ(textOf(ByteView(bytes).subspan(begin + 4, 4)), std::string_view("BIN\0", 4));
        binary.assign(bytes.begin() + static_cast<std::ptrdiff_t>(begin) + 8, bytes.end());
        EXPECT_EQ(number(bytes, begin), binary.size());
    }

    static std::uint32_t number(const Bytes& bytes, std::size_t at) {
        std::uint32_t value = 0;
        std::memcpy(&value, bytes.data() + at, sizeof(value));
        return value;
    }

    template <class Number>
    Number value(std::size_t accessor, std::size_t index) const {
        const Json& view = json["bufferViews"][json["accessors"][accessor]["bufferView"].get<std::size_t>()];
        Number result;
        std::memcpy(&result, binary.data() + view["byteOffset"].get<std::size_t>() + index * sizeof(Number),
                    sizeof(Number));
        return result;
    }

    Json json;
    Bytes binary;
};

} // namespace

TEST(PlyFile, SaysOfEachVertexWhereItIsAndHowWellItIsKnown) {
    const Surface surface = twoTriangles();
    const Bytes bytes = plyFile(surface);
    const test::Ply ply = test::PlyReader(bytes).read();
    ASSERT_EQ(ply.vertices.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(ply.vertices[i].pInRoom, surface.vertices[i].pInRoom);
        EXPECT_NEAR(ply.vertices[i].normal.z(), 0.8, 1e-6);
        EXPECT_EQ(ply.vertices[i].colour, (std::array{10, 128, static_cast<int>(50 * i)}));
        EXPECT_EQ(ply.vertices[i].confidence, 0.75);
        EXPECT_EQ(ply.vertices[i].photos, 3);
    }
    EXPECT_EQ(ply.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}}));
}

TEST(PlyFile, KeepsMillimetresFarFromTheOrigin) {
    const Surface surface = twoTriangles({1e6 + 0.001, -1e6, 0});
    const Bytes bytes = plyFile(surface);
    const test::Ply ply = test::PlyReader(bytes).read();
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(ply.vertices[i].pInRoom, surface.vertices[i].pInRoom);
    }
}

TEST(ObjFile, CountsFromOne) {
    std::istringstream lines(objFile(twoTriangles()));
    std::map<std::string, std::vector<std::string>> byWord;
    for (std::string line; std::getline(lines, line);) {
        byWord[line.substr(0, line.find(' '))].push_back(line);
    }
    ASSERT_EQ(byWord["v"].size(), 4U);
    EXPECT_EQ(byWord["v"][2], "v 1.2500 2.0000 0.5000 0.0392 0.5020 0.3922");
    EXPECT_EQ(byWord["vn"].size(), 4U);
    EXPECT_EQ(byWord["f"], (std::vector<std::string>{"f 1//1 2//2 3//3", "f 1//1 3//3 4//4"}));
}

TEST(GlbFile, HoldsPositionsColoursAndTriangles) {
    const Surface surface = twoTriangles();
    const Glb glb(glbFile(surface, "kitchen \"A\""));
    EXPECT_EQ(glb.json["nodes"][0]["name"], "kitchen \"A\"");
    const Json& primitive = glb.json["meshes"][0]["primitives"][0];
    const auto positions = primitive["attributes"]["POSITION"].get<std::size_t>();
    const auto colours = primitive["attributes"]["COLOR_0"].get<std::size_t>();
    const auto indices = primitive["indices"].get<std::size_t>();
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(glb.value<float>(positions, i), surface.vertices[i / 3].pInRoom[static_cast<int>(i % 3)]);
    }
    EXPECT_EQ(glb.json["accessors"][positions]["min"], (std::vector<double>{0, 0, 0}));
    EXPECT_EQ(glb.json["accessors"][positions]["max"], (std::vector<double>{1.25, 2, 0.5}));
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(glb.value<std::uint32_t>(indices, i), surface.triangles[i / 3][i % 3]);
    }
    // Colours of glTF are of linear light: 128 of 255 in sRGB is 0.2159.
    EXPECT_NEAR(glb.value<std::uint16_t>(colours, 1) / 65535.0, 0.2159, 1e-4);
    EXPECT_EQ(glb.value<std::uint16_t>(colours, 3), 65535);
    for (const Json& view : glb.json["bufferViews"]) {
        EXPECT_EQ(view["byteOffset"].get<int>() % 4, 0);
        EXPECT_LE(view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>(),
                  glb.binary.size());
    }
}

TEST(GlbFile, RefusesASurfaceOfNothing) {
    test::expectError(ErrorKind::InvalidInput, "without vertices", [] { glbFile({}, "room"); });
}

TEST(GlbFile, TurnsTheRoomSoThatYIsUpAndKeepsMillimetresFarAway) {
    const Eigen::Vector3d away(1e6, 2e6, 30);
    const Glb glb(glbFile(twoTriangles(away), "room"));
    const Json& turn = glb.json["nodes"][0]["rotation"];
    const Eigen::Quaterniond rotation(turn[3].get<double>(), turn[0].get<double>(), turn[1].get<double>(),
                                      turn[2].get<double>());
    EXPECT_NEAR((rotation * Eigen::Vector3d::UnitZ() - Eigen::Vector3d::UnitY()).norm(), 0, 1e-12);
    const Json& moved = glb.json["nodes"][1]["translation"];
    const auto positions =
        glb.json["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<std::size_t>();
    EXPECT_NEAR(moved[0].get<double>() + glb.value<float>(positions, 3), away.x() + 1.25, 1e-6);
}

} // namespace spherewalk::place
